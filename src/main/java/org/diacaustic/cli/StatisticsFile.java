package org.diacaustic.cli;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.WholeFile;
import org.diacaustic.json.JsonWriter;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.preprocess.ForwardCounters;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardTotals;
import org.diacaustic.render.Counters;
import org.diacaustic.render.Refined;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.render.Round;

/** What {@code --stats} writes. Parts that did not run are there, as zeros. */
final class StatisticsFile {
    private StatisticsFile() {}

    static void checkWritable(Path path) throws IOException {
        WholeFile.checkWritable(path);
    }

    static void write(Path path, Refined refined, Exposure exposure, Stopwatch watch) throws IOException {
        RenderPlan plan = refined.plan();
        Rendering rendering = refined.rendering();
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
        for (String part : new String[] {"parse", "plan", "render", "write"}) {
            double seconds = part.equals("render") ? rendering.seconds() : watch.seconds(part);
            json.put(part, seconds);
        }
        json.put("preprocess", rendering.forward().traceSeconds());
        json.put("build", rendering.forward().buildSeconds());
        json.end();
        json.name("counters").beginObject();
        json.put("plannedLightRays", plan.forward().map(ForwardPlan::rays).orElse(0L));
        counters(rendering.counters(), rendering.forward().counters(), json);
        json.end();
        json.name("energy").beginObject();
        energy(rendering.forward().ledger(), json);
        json.end();
        json.name("memory").beginObject();
        json.put("imageBytes", plan.imageBytes());
        json.put("mapBytes", rendering.forward().mapBytes());
        json.put("bytesPerCell", bytesPerCell(plan, rendering.forward()));
        json.put("peakHeapBytes", peakHeapBytes());
        json.end();
        json.put("gatherRadius", rendering.forward().gatherRadius());
        json.put("errorEstimate", rendering.errorEstimate());
        json.put("noiseEstimate", rendering.noiseEstimate());
        json.name("rounds").beginArray();
        refined.rounds().forEach(round -> round(round, json));
        json.end();
        json.put("end", refined.end().name().toLowerCase(Locale.ROOT).replace('_', '-'));
        json.put("shortfall", refined.shortfall().orElse(null));
        json.end();
        WholeFile.write(path, out -> out.write(json.toString().getBytes(StandardCharsets.UTF_8)));
    }

    private static void counters(Counters eye, ForwardCounters forward, JsonWriter json) {
        json.put("eyeRays", eye.eyeRays());
        json.put("shadowRays", eye.shadowRays());
        json.put("reflectionRays", eye.reflectionRays());
        json.put("refractionRays", eye.refractionRays());
        json.put("cutRays", eye.cutRays());
        json.put("intersectionTests", eye.intersectionTests());
        json.put("nonFiniteSamples", eye.nonFiniteSamples());
        json.put("primaryLightRays", forward.primaryRays());
        json.put("lightRays", forward.lightRays());
        json.put("lightIntersectionTests", forward.intersectionTests());
        json.put("objectIntersections", forward.objectIntersections());
        json.put("stored", forward.stored());
        json.put("nonFiniteLightRays", forward.nonFinite());
        json.put("nodesExamined", eye.nodesExamined());
        json.put("photonsUsed", eye.photonsUsed());
        json.put("cells", forward.cells());
    }

    private static void round(Round round, JsonWriter json) {
        json.beginObject();
        json.put("lightRays", round.lightRays());
        json.put("passes", round.passes());
        json.put("seconds", round.seconds());
        json.put("estimate", round.estimate());
        json.end();
    }

    /** Of a caustic mesh and the coarser one beside it, for a cell of the former; 0 if there is none. */
    private static double bytesPerCell(RenderPlan plan, ForwardTotals forward) {
        long cells = forward.counters().cells();
        return cells == 0 ? 0 : (double) forward.mapBytes() * plan.passes() / cells;
    }

    private static void energy(EnergyLedger ledger, JsonWriter json) {
        json.put("emitted", ledger.emitted());
        json.put("stored", ledger.stored());
        json.put("absorbed", ledger.absorbed());
        json.put("escaped", ledger.escaped());
        json.put("cut", ledger.cut());
    }

    private static long peakHeapBytes() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP)
                .map(MemoryPoolMXBean::getPeakUsage)
                .mapToLong(usage -> usage.getUsed())
                .sum();
    }
}
