package org.diacaustic.stability;

/** What is said of a case, from the best to the worst. */
public enum Verdict {
    /** Within the tolerance that only careful arithmetic meets; said of cases that state one. */
    STRETCH("stretch"),
    /** Within the tolerance that a backward-stable algorithm meets. */
    PASS("pass"),
    /** Off by more than that, but by too little to change a picture: tolerance + 1e-9 · max(|value|, size of the object). */
    RENDER_SAFE("render-safe"),
    /** The case asks for what was not looked at, or for what lies outside of what is rendered; the reason is given. */
    NOT_APPLICABLE("not applicable"),
    /** Off by more. */
    FAIL("FAIL");

    private final String text;

    Verdict(String text) {
        this.text = text;
    }

    @Override
    public String toString() {
        return text;
    }
}
