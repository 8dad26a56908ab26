package org.diacaustic.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class StudyPageTest {
    private static final long[] RAYS = {1_000, 10_000, 100_000};

    private static FakeStudy fake() {
        return new FakeStudy(6, 0.0001)
                .add(FakeStudy.known("caustic-mesh"), -0.9, 0, RAYS)
                .add(FakeStudy.known("random-nearest"), -0.4, 0, RAYS)
                .add(FakeStudy.known("mine:map=photon-map"), -0.4, 0.05, RAYS);
    }

    private static String page(FakeStudy fake) {
        return new StudyPage(fake.report(), fake.pictures()).text();
    }

    @Test
    void text_givenAStudy_needsNoNetwork() {
        assertThat(page(fake())).doesNotContain("http").doesNotContain("src=").doesNotContain("@import");
    }

    @Test
    void text_givenTheSameTwice_isTheSame() {
        assertThat(page(fake())).isEqualTo(page(fake()));
    }

    @Test
    void text_givenNamesWithMarkup_escapesThem() {
        assertThat(page(fake().refuse(FakeStudy.known("cube-density"), "no <cubes> & no \"quotes\"")))
                .contains("fake &lt;scene&gt;")
                .contains("a &lt;processor&gt;")
                .contains("cube-density: no &lt;cubes&gt; &amp; no &quot;quotes&quot;")
                .doesNotContain("<scene>")
                .doesNotContain("<cubes>");
    }

    @Test
    void text_givenAllPoints_isNotPartial() {
        assertThat(page(fake())).doesNotContain("partial:");
    }

    @Test
    void text_givenMissingPoints_saysSoAtTheTop() {
        String page = page(fake().missing(111));
        assertThat(page).contains("<b>partial: 9 of 120 points.</b>");
        assertThat(page.indexOf("partial:")).isLessThan(page.indexOf("<section"));
    }

    @Test
    void text_givenNothingYet_isAPageWithTheReference() {
        assertThat(page(new FakeStudy(6, 0.01).missing(3)))
                .contains("partial: 0 of 3 points")
                .contains("The reference")
                .endsWith("</html>\n");
    }

    @Test
    void text_givenFivePercentTooMuch_callsItWrong() {
        String page = page(fake()).replace('\u00a0', ' ');
        String words = "<li class=\"wrong\">mine is 5.00 % too bright at every budget: more rays do not help.";
        assertThat(page.indexOf(words)).isPositive().isLessThan(page.indexOf("<section"));
        assertThat(page.indexOf(words, page.indexOf("id=\"brightness\""))).isPositive();
    }

    @Test
    void text_givenStrips_keepsEachPictureOnce() {
        String page = page(fake());
        long pictures =
                Pattern.compile("data:image/png").matcher(page).results().count();
        // Each technique has 1 or 2 pictures in the strips, each with its map; the reference and its map, in its
        // section again with
        // the pixels that count and its halves; and the scale.
        long distinct = Pattern.compile("base64,[^)]*")
                .matcher(page)
                .results()
                .map(match -> match.group())
                .distinct()
                .count();
        assertThat(pictures).isBetween(2 * 3 + 2 + 3 + 1L, 4 * 3 + 2 + 3 + 1L);
        assertThat(distinct).isGreaterThanOrEqualTo(pictures - 2);
    }

    @Test
    void text_givenNoPictures_namesTheirTechniques() {
        FakeStudy fake = fake();
        String page = new StudyPage(fake.report(), (technique, point) -> Optional.empty()).text();
        assertThat(page).contains("No picture here: caustic-mesh, mine, random-nearest.");
    }

    @Test
    void text_givenTargets_saysWhatIsReachedAndWhatNot() {
        // Chance of the mesh is N^-0.9: below 0.3 % with 1,000 rays, the first budget. What is 5 % off never comes to 3
        // %.
        String row =
                page(fake()).replace('\u00a0', ' ').split("<th>mine</th>")[1].split("</tr>")[0];
        assertThat(row).contains("not reached (best 5.").contains("class=\"missed\"");
        String mesh = page(fake())
                .replace('\u00a0', ' ')
                .split("<th>caustic-mesh</th>")[1]
                .split("</tr>")[0];
        assertThat(mesh).contains("class=\"best\" data-title=\"3 %\">≤ ");
    }

    @Test
    void text_givenARun_saysHowToRunItAgainAndHowFewSeeds() {
        assertThat(page(fake()))
                .contains("diacaustic study fake.yaml -o out")
                .contains("5; intervals of fewer than 20 are rough");
    }

    @Test
    void text_givenTags_closesThem() {
        String page = page(fake());
        for (String tag :
                new String[] {"section", "div", "details", "table", "figure", "svg", "g", "label", "ul", "tr"}) {
            long opened =
                    Pattern.compile("<" + tag + "[ >]").matcher(page).results().count();
            long closed =
                    Pattern.compile("</" + tag + ">").matcher(page).results().count();
            assertThat(opened).as(tag).isPositive().isEqualTo(closed);
        }
    }
}
