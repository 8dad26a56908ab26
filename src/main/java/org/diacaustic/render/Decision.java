package org.diacaustic.render;

/**
 * One thing the plan decided.
 *
 * @param part what it is about, such as "shader" or "top-level tree"
 * @param used whether it runs; false if it is left out
 * @param choice what was taken, or what is left out
 * @param reason why, in a phrase
 */
public record Decision(String part, boolean used, String choice, String reason) {

    @Override
    public String toString() {
        return (used ? "uses  " : "omits ") + part + ": " + choice + " (" + reason + ")";
    }
}
