package org.diacaustic.cli;

import java.util.List;
import org.diacaustic.json.JsonWriter;
import org.diacaustic.render.Decision;
import org.diacaustic.render.RenderPlan;

/** The plan as JSON: what is used and what is left out. */
final class PlanJson {
    private PlanJson() {}

    /** Writes the members {@code used} and {@code leftOut}. */
    static void write(RenderPlan plan, JsonWriter json) {
        write("used", plan.decisions().stream().filter(Decision::used).toList(), json);
        write("leftOut", plan.decisions().stream().filter(d -> !d.used()).toList(), json);
    }

    private static void write(String name, List<Decision> decisions, JsonWriter json) {
        json.name(name).beginArray();
        for (Decision decision : decisions) {
            json.beginObject();
            json.put("part", decision.part());
            json.put("choice", decision.choice());
            json.put("reason", decision.reason());
            json.end();
        }
        json.end();
    }
}
