package org.diacaustic.cli;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.WholeFile;
import org.diacaustic.render.Counters;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;

/** What {@code --stats} writes. Parts that did not run are there, as zeros. */
final class StatisticsFile {
    private StatisticsFile() {}

    static void checkWritable(Path path) throws IOException {
        WholeFile.checkWritable(path);
    }

    static void write(Path path, RenderPlan plan, Rendering rendering, Exposure exposure, Stopwatch watch)
            throws IOException {
        JsonWriter json = new JsonWriter();
        json.beginObject();
        json.member("seed", plan.settings().seed());
        json.member("threads", rendering.threads());
        json.member("complete", rendering.isComplete());
        json.member("width", rendering.image().width());
        json.member("height", rendering.image().height());
        json.member("exposure", exposure.factor());
        json.name("plan").beginObject();
        PlanJson.write(plan, json);
        json.endObject();
        json.name("seconds").beginObject();
        for (String part : new String[] {"parse", "plan", "preprocess", "build", "render", "write"}) {
            json.member(part, watch.seconds(part));
        }
        json.endObject();
        json.name("counters").beginObject();
        counters(rendering.counters(), json);
        json.endObject();
        json.name("energy").beginObject();
        for (String part : new String[] {"emitted", "stored", "absorbed", "escaped", "cut"}) {
            json.member(part, 0.0);
        }
        json.endObject();
        json.name("memory").beginObject();
        json.member("imageBytes", plan.imageBytes());
        json.member("mapBytes", 0);
        json.member("peakHeapBytes", peakHeapBytes());
        json.endObject();
        json.member("errorEstimate", Double.NaN);
        json.endObject();
        WholeFile.write(path, out -> out.write((json + "\n").getBytes(StandardCharsets.UTF_8)));
    }

    private static void counters(Counters counters, JsonWriter json) {
        json.member("eyeRays", counters.eyeRays());
        json.member("shadowRays", counters.shadowRays());
        json.member("reflectionRays", counters.reflectionRays());
        json.member("refractionRays", counters.refractionRays());
        json.member("intersectionTests", counters.intersectionTests());
        json.member("nonFiniteSamples", counters.nonFiniteSamples());
        for (String forward :
                new String[] {"lightRays", "objectIntersections", "stored", "nodesExamined", "photonsUsed", "cells"}) {
            json.member(forward, 0);
        }
    }

    private static long peakHeapBytes() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP)
                .map(MemoryPoolMXBean::getPeakUsage)
                .mapToLong(usage -> usage.getUsed())
                .sum();
    }
}
