package org.diacaustic.render;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import org.diacaustic.light.Light;
import org.diacaustic.material.TransportMode;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.PreProcessor;
import org.diacaustic.preprocess.PreProcessors;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.NonRefractiveShader;
import org.diacaustic.shader.NonTransparentShader;
import org.diacaustic.shader.Shader;
import org.diacaustic.transport.PathRules;

/**
 * A scene and settings resolved, once, into what runs and what is left out, each with its reason. Immutable; the passes
 * read nothing else.
 */
public final class RenderPlan {
    /** Pixels along the side of a tile. A constant, so that what a tile counts does not depend on the machine. */
    static final int TILE_SIZE = 16;

    private final Scene scene;
    private final Settings settings;
    private final SceneIndex index;
    private final Map<String, Shader> shaders;
    private final List<PreProcessor> preProcessors;
    private final Optional<ForwardPlan> forward;
    private final Shader shader;
    private final MediumStack mediaAtEye;
    private final Light[] visibleLights;
    private final List<Decision> decisions;

    /** @param why the decision about the map, if it was taken before; or null */
    private RenderPlan(
            Scene scene,
            Settings settings,
            SceneIndex index,
            Map<String, Shader> shaders,
            List<PreProcessor> preProcessors,
            Decision why) {
        this.scene = scene;
        this.settings = settings;
        this.index = index;
        this.shaders = shaders;
        this.preProcessors = List.copyOf(preProcessors);
        SceneTraits traits = new SceneTraits(scene);
        ForwardChoice forwardChoice = new ForwardChoice(scene, index, settings, traits);
        this.forward = forwardChoice.plan(preProcessors);
        PlanReasons reasons = new PlanReasons(scene, settings, index, traits, forward.isPresent());
        String name = settings.shader().equals(Settings.AUTO) ? reasons.bestShader() : settings.shader();
        this.shader = shaders.get(name);
        if (shader == null) {
            throw new PlanException(
                    "unknown shader '" + name + "'; known are auto, " + String.join(", ", shaders.keySet()));
        }
        this.mediaAtEye = MediumLocator.locate(index, scene.camera().from());
        this.visibleLights = scene.lights().stream().filter(Light::isVisible).toArray(Light[]::new);
        List<Decision> all = new ArrayList<>(forwardChoice.decisions());
        all.addAll(reasons.decisions(shader.name(), mediaAtEye.current()));
        if (why != null) {
            all.replaceAll(decision -> decision.part().equals(why.part()) ? why : decision);
        }
        this.decisions = List.copyOf(all);
    }

    /**
     * Plans a render with the built-in shading models and pre-processors and those that {@link ServiceLoader} finds.
     *
     * @throws PlanException if a name is unknown or choices exclude each other
     */
    public static RenderPlan of(Scene scene, Settings settings) {
        List<Shader> found = new ArrayList<>();
        ServiceLoader.load(Shader.class).forEach(found::add);
        return of(scene, settings, found, PreProcessors.installed());
    }

    /**
     * Plans a render with shading models and pre-processors of the caller's beside the built-in ones.
     *
     * @throws PlanException as above, or if two have the same name
     */
    public static RenderPlan of(
            Scene scene, Settings settings, List<Shader> additional, List<PreProcessor> preProcessors) {
        Map<String, Shader> shaders = new LinkedHashMap<>();
        shaders.put(NonTransparentShader.NAME, new NonTransparentShader());
        shaders.put(NonRefractiveShader.NAME, new NonRefractiveShader(settings.scatterRules(), settings.attenuates()));
        for (Shader shader : additional) {
            if (shader.name().equals(Settings.AUTO) || shaders.putIfAbsent(shader.name(), shader) != null) {
                throw new PlanException(
                        "a shader of one's own must not be named '" + shader.name() + "': that is the name of another");
            }
        }
        SceneIndex index = SceneIndex.of(scene.objects(), settings.usesListOrder());
        return new RenderPlan(scene, settings, index, shaders, preProcessors, null);
    }

    /**
     * The same with the same map, but for the light rays of a pass, where 0 leaves them to the plan, and the number of
     * passes.
     */
    RenderPlan with(long rays, int passes) {
        Settings.Builder changed = settings.toBuilder()
                .forward(
                        settings.forward().toBuilder().rays(rays).passes(passes).build());
        // Which map is the better one depends on the rays, but rounds are to be of one kind.
        forward.map(ForwardPlan::map)
                .ifPresent(
                        map -> changed.maps(settings.maps().toBuilder().map(map).build()));
        Decision why = decisions.stream()
                .filter(decision -> decision.part().equals("map"))
                .findFirst()
                .orElse(null);
        return new RenderPlan(scene, changed.build(), index, shaders, preProcessors, why);
    }

    public Scene scene() {
        return scene;
    }

    public Settings settings() {
        return settings;
    }

    public Shader shader() {
        return shader;
    }

    /** The forward pass; nothing if there is none. */
    public Optional<ForwardPlan> forward() {
        return forward;
    }

    /** How many times the picture is rendered, each with a forward pass of its own. */
    public int passes() {
        return forward.map(ForwardPlan::passes).orElse(1);
    }

    /**
     * Whether lamps light surfaces along straight lines only, so that straight shadow rays through what is transparent are exact:
     * nothing bends light, none is mirrored onto surfaces, and the forward pass would follow it through all that it can cross.
     */
    public boolean isStraight() {
        long boundaries = scene.objects().stream()
                .filter(object -> object.material().isTransparent())
                .mapToLong(object -> object.shape().isClosed() ? 2 : 1)
                .sum();
        return new SceneTraits(scene).isStraight(settings.forward())
                && settings.forward().maxDepth() >= boundaries;
    }

    /** What runs and what is left out, in the order in which it would run. */
    public List<Decision> decisions() {
        return decisions;
    }

    /** Whether two maps are compared, which tells the error of what they bring. */
    public boolean estimatesError() {
        return forward.map(ForwardPlan::map).orElse(MapName.NONE) == MapName.CAUSTIC_MESH;
    }

    /** The bytes that the picture itself takes; the largest long if that is too small a number. */
    public long imageBytes() {
        return imageBytes(passes() > 1);
    }

    /** As {@link #imageBytes()}, if there may or may not be more than one pass. */
    private long imageBytes(boolean isMean) {
        long pixels = (long) scene.camera().width() * scene.camera().height();
        long bytesPerPixel =
                3L * Float.BYTES + (isMean ? 6L * Double.BYTES : 0) + (estimatesError() ? 3L * Float.BYTES : 0);
        return pixels > Long.MAX_VALUE / bytesPerPixel ? Long.MAX_VALUE : pixels * bytesPerPixel;
    }

    /** How eye rays are followed. */
    PathRules eyeRules() {
        return eyeRules(settings.minimumThroughput());
    }

    /** How eye rays are followed that carry at least this fraction of what started. */
    PathRules eyeRules(double minimumThroughput) {
        return new PathRules(
                settings.scatterRules(),
                TransportMode.RADIANCE,
                settings.maxDepth(),
                minimumThroughput,
                true,
                settings.usesListOrder());
    }

    SceneIndex index() {
        return index;
    }

    /** The media the eye is in; not to be changed. */
    MediumStack mediaAtEye() {
        return mediaAtEye;
    }

    Light[] visibleLights() {
        return visibleLights;
    }

    /** Diffuse radiance ÷ (reflected fraction × irradiance): 1/π, or 1 in the thesis. */
    double diffuseFactor() {
        return settings.normalizesDiffuse() ? 1 / Math.PI : 1;
    }

    /** The radiance of a highlight ÷ (mirrored fraction × irradiance), at a cosine from the mirrored direction. */
    double highlight(double cosine, double exponent) {
        if (cosine <= 0) {
            return 0;
        }
        // StrictMath.pow would allocate.
        double lobe = StrictMath.exp(exponent * StrictMath.log(Math.min(cosine, 1)));
        return settings.normalizesHighlights() ? lobe * (exponent + 1) / (2 * Math.PI) : lobe;
    }

    /** Light rays that are to be chosen in a pass; 0 if there is no forward pass. */
    long lightRays() {
        return forward.map(ForwardPlan::rays).orElse(0L);
    }

    /** Eye rays of a pass; a number that no whole one need hold. */
    double eyeRays() {
        return (double) scene.camera().width() * scene.camera().height() * settings.samples();
    }

    int tileCount() {
        return tilesAcross() * tilesDown();
    }

    int tilesAcross() {
        return (scene.camera().width() + TILE_SIZE - 1) / TILE_SIZE;
    }

    int tilesDown() {
        return (scene.camera().height() + TILE_SIZE - 1) / TILE_SIZE;
    }

    /**
     * @param isMean whether there may be more than one pass
     * @throws ResourceLimitException if the picture does not fit in the memory that is left
     */
    void requireMemory(boolean isMean) {
        Runtime runtime = Runtime.getRuntime();
        long available = runtime.maxMemory() - (runtime.totalMemory() - runtime.freeMemory());
        long needed = imageBytes(isMean);
        long pixels = (long) scene.camera().width() * scene.camera().height();
        if (needed > available || pixels > (Integer.MAX_VALUE - 8) / 3) {
            throw ResourceLimitException.ofMemory(
                    "a picture of " + scene.camera().width() + " x "
                            + scene.camera().height(),
                    needed,
                    Math.min(available, 4L * Integer.MAX_VALUE));
        }
    }

    /** @throws ResourceLimitException if so many passes have more tiles than can be counted */
    void requireCountable(int passes) {
        if ((long) passes * tileCount() > Integer.MAX_VALUE) {
            throw new ResourceLimitException(passes + " passes over a picture of this size are too many to be counted");
        }
    }
}
