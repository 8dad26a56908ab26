package org.diacaustic.cli;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.WholeFile;
import org.diacaustic.json.JsonWriter;
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
        json.put("seed", plan.settings().seed());
        json.put("threads", rendering.threads());
        json.put("complete", rendering.isComplete());
        json.put("width", rendering.image().width());
        json.put("height", rendering.image().height());
        json.put("exposure", exposure.factor());
        json.name("plan").beginObject();
        PlanJson.write(plan, json);
        json.end();
        json.name("seconds").beginObject();
        for (String part : new String[] {"parse", "plan", "preprocess", "build", "render", "write"}) {
            json.put(part, watch.seconds(part));
        }
        json.end();
        json.name("counters").beginObject();
        counters(rendering.counters(), json);
        json.end();
        json.name("energy").beginObject();
        for (String part : new String[] {"emitted", "stored", "absorbed", "escaped", "cut"}) {
            json.put(part, 0.0);
        }
        json.end();
        json.name("memory").beginObject();
        json.put("imageBytes", plan.imageBytes());
        json.put("mapBytes", 0);
        json.put("peakHeapBytes", peakHeapBytes());
        json.end();
        json.put("errorEstimate", Double.NaN);
        json.end();
        WholeFile.write(path, out -> out.write(json.toString().getBytes(StandardCharsets.UTF_8)));
    }

    private static void counters(Counters counters, JsonWriter json) {
        json.put("eyeRays", counters.eyeRays());
        json.put("shadowRays", counters.shadowRays());
        json.put("reflectionRays", counters.reflectionRays());
        json.put("refractionRays", counters.refractionRays());
        json.put("cutRays", counters.cutRays());
        json.put("intersectionTests", counters.intersectionTests());
        json.put("nonFiniteSamples", counters.nonFiniteSamples());
        for (String forward :
                new String[] {"lightRays", "objectIntersections", "stored", "nodesExamined", "photonsUsed", "cells"}) {
            json.put(forward, 0);
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
