package org.diacaustic.trial;

import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.Operations;

/** All operations that run in this process. */
public final class Trials {
    private Trials() {}

    /** @param launcher for processes that pictures are held against */
    public static Operations all(Launcher launcher) {
        Operations operations = new Operations();
        RefractionTrials.addTo(operations);
        SceneTrials.addTo(operations);
        RandomSceneTrials.addTo(operations);
        SpareTrials.addTo(operations);
        DeterminismTrials.addTo(operations, launcher);
        PhotonTreeTrials.addTo(operations);
        LayerTrials.addTo(operations);
        DepartureTrials.addTo(operations);
        RootTrials.addTo(operations);
        TorusTrials.addTo(operations);
        TriangleTrials.addTo(operations);
        PolygonTrials.addTo(operations);
        HierarchyTrials.addTo(operations);
        SumTrials.addTo(operations);
        MappingTrials.addTo(operations);
        AmbientMapTrials.addTo(operations);
        BumpTrials.addTo(operations);
        AbsorptionTrials.addTo(operations);
        CameraTrials.addTo(operations);
        PictureTrials.addTo(operations);
        NestingTrials.addTo(operations);
        CombinationTrials.addTo(operations);
        LightTrials.addTo(operations);
        LampTrials.addTo(operations);
        DensityTrials.addTo(operations);
        KernelTrials.addTo(operations);
        ProgressiveTrials.addTo(operations);
        ForwardDensityTrials.addTo(operations);
        EmissionTrials.addTo(operations);
        StreamTrials.addTo(operations);
        FlatOpticsTrials.addTo(operations);
        CurvedOpticsTrials.addTo(operations);
        ImageTrials.addTo(operations);
        WalkTrials.addTo(operations);
        LedgerTrials.addTo(operations);
        ControlTrials.addTo(operations);
        return operations;
    }
}
