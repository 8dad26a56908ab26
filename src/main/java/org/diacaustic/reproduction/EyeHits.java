package org.diacaustic.reproduction;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;

/**
 * Where the eye pass asks for indirect light, noted by standing in for the map. The same points can then be asked of any
 * map, to count what that costs. They do not depend on the light, so a scene needs one only.
 */
final class EyeHits implements IlluminationMap {
    private final List<Note> notes = Collections.synchronizedList(new ArrayList<>());

    /** What one task has asked for. */
    private static final class Note implements Lookup {
        final List<SurfacePoint> points = new ArrayList<>();

        @Override
        public void irradiance(SurfacePoint at, Rgb irradiance) {
            SurfacePoint copy = new SurfacePoint();
            copy.x = at.x;
            copy.y = at.y;
            copy.z = at.z;
            copy.normalX = at.normalX;
            copy.normalY = at.normalY;
            copy.normalZ = at.normalZ;
            copy.object = at.object;
            copy.front = at.front;
            points.add(copy);
            irradiance.set(0, 0, 0);
        }

        @Override
        public long nodesExamined() {
            return 0;
        }

        @Override
        public long photonsUsed() {
            return 0;
        }
    }

    @Override
    public Lookup lookup() {
        Note note = new Note();
        notes.add(note);
        return note;
    }

    @Override
    public long bytes() {
        return 0;
    }

    /** The points, in no particular order. */
    List<SurfacePoint> points() {
        return notes.stream().flatMap(note -> note.points.stream()).toList();
    }

    /** The object of a point and its side, as one number. */
    static int place(SurfacePoint at) {
        return at.object << 1 | (at.front ? 1 : 0);
    }
}
