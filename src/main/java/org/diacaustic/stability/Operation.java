package org.diacaustic.stability;

/**
 * A kind of question: how its cases are put to the code that renders.
 *
 * @param name as cases name it
 * @param meaning what is run, and how rules that cases give in words are read, in a sentence or two
 * @param need what must be allowed before it runs
 */
public record Operation(String name, String meaning, Need need, Trial trial) {

    /** What an operation needs beyond this process. */
    public enum Need {
        NOTHING,
        /** It starts processes: {@code --faults}. */
        FAULTS
    }

    /** Puts one case to the code, and compares what comes. */
    @FunctionalInterface
    public interface Trial {
        /** @throws Exception whatever breaks off: the case has failed then */
        void run(NumericCase asked, Checks checks) throws Exception;
    }
}
