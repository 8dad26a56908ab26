package org.diacaustic.trial;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.map.Chart;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.SphericalMapping;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** From surfaces to maps. */
final class MappingTrials {
    private MappingTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "sphere_uv_thesis_eq4",
                "The spherical mapping of textures, the chart of ambient maps, and, for an upright pole, the sphere's own mapping;"
                        + " u = 0 and u = 1 are the same.",
                MappingTrials::sphere);
        operations.add(
                "texel_index",
                "The texel of an ambient map on a unit square at (u, v); any of those that the case lists is right.",
                MappingTrials::texel);
        operations.add(
                "quad_inverse_uv",
                "The inverse mapping of a polygon of four corners, in the plane z = 0 and in two others.",
                MappingTrials::quadrilateral);
    }

    private static void sphere(NumericCase asked, Checks checks) {
        Vector3 normal = Stage.vector(asked.inputs().vector("normal"));
        Vector3 pole = Stage.vector(asked.inputs().vector("pole"));
        Vector3 equator = Stage.vector(asked.inputs().vector("equator"));
        Hit hit = new Hit();
        hit.setPoint(normal.x(), normal.y(), normal.z(), 0);
        hit.setNormal(normal.x(), normal.y(), normal.z());
        new SphericalMapping(Vector3.ZERO, pole, equator).map(hit);
        compare("", hit.u, hit.v, asked, checks);
        checks.holds("tangents are finite", tangentsAreFinite(hit));
        Chart chart = Chart.spherical(Vector3.ZERO, pole, equator);
        double u = chart.u(normal.x(), normal.y(), normal.z());
        compare(" of the chart", u, chart.v(normal.x(), normal.y(), normal.z()), asked, checks);
        if (pole.normalized().equals(Vector3.UNIT_Y) && equator.normalized().equals(Vector3.UNIT_X)) {
            new Sphere(Vector3.ZERO, 1).inverseMap(hit);
            compare(" of the sphere", hit.u, hit.v, asked, checks);
        }
    }

    private static void compare(String whose, double u, double v, NumericCase asked, Checks checks) {
        checks.holds("u and v" + whose + " within 0 and 1", u >= 0 && u <= 1 && v >= 0 && v <= 1);
        if (asked.expected().isDecimal("u")) {
            BigDecimal expected = asked.expected().decimal("u");
            double off = u - expected.doubleValue();
            // The same place, counted from the turn before or after.
            BigDecimal turned = expected.add(BigDecimal.valueOf(off > 0.5 ? 1 : off < -0.5 ? -1 : 0));
            checks.number("u" + whose, turned, u, "u");
        }
        checks.number("v" + whose, asked.expected().decimal("v"), v, "v");
    }

    private static boolean tangentsAreFinite(Hit hit) {
        return Double.isFinite(hit.tangentUX + hit.tangentUY + hit.tangentUZ)
                && Double.isFinite(hit.tangentVX + hit.tangentVY + hit.tangentVZ);
    }

    private static void texel(NumericCase asked, Checks checks) {
        int width = (int) asked.inputs().integer("width");
        int height = (int) asked.inputs().integer("height");
        Chart square = Chart.planar(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_Y);
        TexelGrid grid = new TexelGrid(square, width, height);
        double[][] places = asked.inputs().rows("uv");
        List<?> expected = asked.expected().list("index");
        checks.same("length of index", expected.size(), places.length);
        for (int i = 0; i < places.length; i++) {
            int texel = grid.texel(places[i][0], places[i][1], 0);
            List<Integer> got = List.of(texel % width, texel / width);
            checks.rule(
                    "texel at " + Arrays.toString(places[i]),
                    String.valueOf(expected.get(i)),
                    got.toString(),
                    isAmong(got, expected.get(i)));
        }
    }

    /** Whether a pair is a listed one, or one of the listed pairs. */
    private static boolean isAmong(List<Integer> pair, Object listed) {
        if (!(listed instanceof List<?> list) || list.isEmpty()) {
            throw new CaseFault("expected.index should hold pairs, but holds " + listed);
        }
        if (list.get(0) instanceof List<?>) {
            return list.stream().anyMatch(one -> isAmong(pair, one));
        }
        return list.size() == 2
                && list.get(0) instanceof Number column
                && list.get(1) instanceof Number row
                && column.longValue() == pair.get(0)
                && row.longValue() == pair.get(1);
    }

    private static void quadrilateral(NumericCase asked, Checks checks) {
        for (int axis = 0; axis < 3; axis++) {
            Vector3[] corners = new Vector3[4];
            for (int i = 0; i < 4; i++) {
                corners[i] = inPlane(asked.inputs().numbers("p" + i), axis);
            }
            Vector3 at = inPlane(asked.inputs().numbers("P"), axis);
            Hit hit = new Hit();
            hit.setPoint(at.x(), at.y(), at.z(), 0);
            try {
                ConvexPolygon.twoSided(corners).inverseMap(hit);
            } catch (IllegalArgumentException refused) {
                checks.notApplicable("such a quadrilateral is refused: " + refused.getMessage());
                return;
            }
            String where = " across " + "zxy".charAt(axis);
            checks.number("u" + where, asked.expected().decimal("u"), hit.u, "u");
            checks.number("v" + where, asked.expected().decimal("v"), hit.v, "v");
        }
    }

    /** A point of the plane across z, x or y. */
    private static Vector3 inPlane(double[] point, int axis) {
        return switch (axis) {
            case 0 -> new Vector3(point[0], point[1], 0);
            case 1 -> new Vector3(0, point[0], point[1]);
            default -> new Vector3(point[1], 0, point[0]);
        };
    }
}
