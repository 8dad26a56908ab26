package org.diacaustic.chart;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Moves labels that stand one above the other as little as keeps them apart. */
public final class LabelColumn {
    private LabelColumn() {}

    /** Labels that touch, as one: the mean of where they want their first to be, and how many they are. */
    private record Block(double wished, int count) {}

    /**
     * Where labels come to stand.
     *
     * @param wished where each wants to be
     * @param gap least distance of neighbours
     * @param least where the first may stand at least, {@code largest} where the last at most; if they do not fit between, they
     *     reach beyond {@code largest}
     * @return one place for each, in the order of {@code wished}
     */
    public static double[] spread(double[] wished, double gap, double least, double largest) {
        List<Integer> order = IntStream.range(0, wished.length)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> wished[i]))
                .toList();
        List<Block> blocks = new ArrayList<>();
        for (int label : order) {
            Block last = new Block(wished[label], 1);
            while (!blocks.isEmpty()
                    && end(blocks.get(blocks.size() - 1), gap, least, largest) + gap
                            > start(last, gap, least, largest)) {
                last = joined(blocks.remove(blocks.size() - 1), last, gap);
            }
            blocks.add(last);
        }
        double[] places = new double[wished.length];
        int next = 0;
        for (Block block : blocks) {
            for (int i = 0; i < block.count; i++) {
                places[order.get(next++)] = start(block, gap, least, largest) + i * gap;
            }
        }
        return places;
    }

    private static Block joined(Block above, Block below, double gap) {
        int count = above.count + below.count;
        double wished = above.count * above.wished + below.count * (below.wished - above.count * gap);
        return new Block(wished / count, count);
    }

    private static double start(Block block, double gap, double least, double largest) {
        return Math.max(least, Math.min(largest - (block.count - 1) * gap, block.wished));
    }

    private static double end(Block block, double gap, double least, double largest) {
        return start(block, gap, least, largest) + (block.count - 1) * gap;
    }
}
