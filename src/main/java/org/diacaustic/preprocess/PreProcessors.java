package org.diacaustic.preprocess;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import org.diacaustic.scene.Settings;

/** The pre-processors that settings can name. */
public final class PreProcessors {
    private PreProcessors() {}

    /**
     * The built-in ones and those that {@link ServiceLoader} finds, by name.
     *
     * @throws ForwardPlanException if two have the same name
     */
    public static Map<String, PreProcessor> byName() {
        Map<String, PreProcessor> all = new LinkedHashMap<>();
        for (PreProcessor builtIn : List.of(
                new RandomPreProcessor(),
                new MonteCarloPreProcessor(),
                new PlanarPreProcessor(),
                new CubePreProcessor(),
                new OwnMapPreProcessor(),
                new AdaptivePreProcessor())) {
            all.put(builtIn.name(), builtIn);
        }
        for (PreProcessor found : ServiceLoader.load(PreProcessor.class)) {
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
