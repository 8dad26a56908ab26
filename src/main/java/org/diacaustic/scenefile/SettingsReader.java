package org.diacaustic.scenefile;

import java.util.Map;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.scene.Settings;

/** Reads {@code settings}: {@code thesis: true} sets all others to the thesis' ways, and each may then be set back. */
final class SettingsReader {
    private static final Map<String, Boolean> TOTAL_INTERNAL_REFLECTION =
            new Kinds<Boolean>().with("reflect", false).with("drop", true).map();

    private SettingsReader() {}

    static Settings read(MappingReader in) {
        Settings.Builder settings = Settings.physical().toBuilder();
        if (in.flag("thesis").or(false)) {
            settings.thesis();
        }
        in.text("shader").optional().ifPresent(settings::shader);
        in.integer("samples").atLeast(1).optional().ifPresent(settings::samples);
        in.integer("max-depth").atLeast(0).optional().ifPresent(settings::maxDepth);
        in.number("minimum-throughput").atLeast(0).below(1).optional().ifPresent(settings::minimumThroughput);
        in.longInteger("seed").optional().ifPresent(settings::seed);
        exposure(in, settings);
        in.flag("fresnel").optional().ifPresent(settings::fresnel);
        in.choice("total-internal-reflection", TOTAL_INTERNAL_REFLECTION)
                .optional()
                .ifPresent(settings::dropTotalInternalReflection);
        in.flag("radiance-scaling").optional().ifPresent(settings::scaleRadiance);
        in.choice("back-facing-bump", ScatterRules.BackFacingBump.class)
                .optional()
                .ifPresent(settings::backFacingBump);
        in.flag("diffuse-normalization").optional().ifPresent(settings::normalizeDiffuse);
        in.flag("highlight-normalization").optional().ifPresent(settings::normalizeHighlights);
        in.flag("attenuation").optional().ifPresent(settings::attenuate);
        in.flag("clamp").optional().ifPresent(settings::clamp);
        in.flag("list-order").optional().ifPresent(settings::listOrder);
        Settings start = settings.build();
        settings.forward(ForwardReader.read(in, start.forward()));
        settings.maps(MapSettingsReader.read(in, start.maps()));
        in.finish();
        return settings.build();
    }

    private static void exposure(MappingReader in, Settings.Builder settings) {
        if (in.form("exposure") == Form.TEXT) {
            String text = in.text("exposure").or("");
            if (!text.equals("auto")) {
                in.error("exposure", "expected a number above 0 or auto, found '" + text + "'");
            }
            settings.automaticExposure();
        } else {
            in.number("exposure").above(0).optional().ifPresent(settings::exposure);
        }
    }
}
