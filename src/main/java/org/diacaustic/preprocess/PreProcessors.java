package org.diacaustic.preprocess;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import org.diacaustic.scene.Settings;

/** The pre-processors that settings can name. */
public final class PreProcessors {
    private PreProcessors() {}

    /** Those that {@link ServiceLoader} finds. */
    public static List<PreProcessor> installed() {
        return ServiceLoader.load(PreProcessor.class).stream()
                .map(ServiceLoader.Provider::get)
                .toList();
    }

    /**
     * The built-in ones and others, by name.
     *
     * @throws ForwardPlanException if two have the same name
     */
    public static Map<String, PreProcessor> byName(List<PreProcessor> additional) {
        Map<String, PreProcessor> all = new LinkedHashMap<>();
        for (PreProcessor builtIn : List.of(
                new RandomPreProcessor(),
                new MonteCarloPreProcessor(),
                new PlanarPreProcessor(),
                new CubePreProcessor(),
                new AdaptivePreProcessor(),
                new OwnMapPreProcessor())) {
            all.put(builtIn.name(), builtIn);
        }
        for (PreProcessor found : additional) {
            if (found.name().equals(Settings.AUTO)
                    || found.name().equals(Settings.NONE)
                    || all.putIfAbsent(found.name(), found) != null) {
                throw new ForwardPlanException("a pre-processor of one's own must not be named '" + found.name()
                        + "': that is the name of another");
            }
        }
        return all;
    }
}
