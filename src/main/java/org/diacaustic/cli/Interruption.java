package org.diacaustic.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Makes Ctrl-C and SIGTERM stop work and then wait until what there is has been saved. The process then ends with 130
 * or 143, as the virtual machine does on its own.
 */
final class Interruption {
    /** If saving hangs, for instance on a dead disc, the process must end all the same. */
    private static final long LONGEST_SAVE_SECONDS = 20;

    private final CountDownLatch saved = new CountDownLatch(1);
    private final Thread hook;

    private Interruption(Runnable cancel) {
        hook = new Thread(() -> {
            cancel.run();
            try {
                saved.await(LONGEST_SAVE_SECONDS, TimeUnit.SECONDS);
            } catch (InterruptedException impatient) {
                Thread.currentThread().interrupt();
            }
        });
    }

    /** @param cancel ends the work soon */
    static Interruption cancelling(Runnable cancel) {
        Interruption interruption = new Interruption(cancel);
        Runtime.getRuntime().addShutdownHook(interruption.hook);
        return interruption;
    }

    /** Says that all is saved; from now on nothing needs to be waited for. */
    void saved() {
        saved.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException alreadyShuttingDown) {
            // The hook is running and has just been released.
            return;
        }
    }
}
