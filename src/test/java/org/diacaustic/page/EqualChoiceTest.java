package org.diacaustic.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.assertj.core.data.Offset;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.TechniqueStudy;
import org.junit.jupiter.api.Test;

/** A light ray of a fake study takes 2.06 microseconds of processors, and chance is a power of their number. */
class EqualChoiceTest {
    private final FakeStudy fake = new FakeStudy(4, 0);

    private List<TechniqueStudy> studies() {
        return fake.report().studies();
    }

    @Test
    void ofTime_givenOneThatWentFurther_takesThePointsThatAllHave() {
        fake.add(FakeStudy.known("caustic-mesh"), -0.5, 0, 1_000, 10_000, 100_000);
        fake.add(FakeStudy.known("random-nearest"), -0.5, 0, 1_000, 9_000);
        EqualChoice choice = EqualChoice.ofTime(studies());
        assertThat(choice.limit()).isCloseTo(0.0206, Offset.offset(1e-6));
        assertThat(choice.points().values()).extracting(StudyPoint::rays).containsExactly(10_000L, 9_000L);
    }

    @Test
    void ofTime_givenOneThatIsTooSlow_leavesItOut() {
        fake.add(FakeStudy.known("caustic-mesh"), -0.5, 0, 1_000);
        fake.add(FakeStudy.known("random-nearest"), -0.5, 0, 1_100);
        fake.add(FakeStudy.known("planar-nearest"), -0.5, 0, 50_000);
        assertThat(EqualChoice.ofTime(studies()).points().keySet())
                .extracting(study -> study.technique().name())
                .containsExactly("caustic-mesh", "random-nearest");
    }

    @Test
    void ofError_givenSteepAndFlat_takesTheCheapestPointsBelow() {
        // 10 % after 10² rays on the one, and after 10⁴ on the other; 1 % and 0.1 % on the steep one alone.
        fake.add(FakeStudy.known("caustic-mesh"), -0.5, 0, 100, 10_000, 1_000_000);
        fake.add(FakeStudy.known("random-nearest"), -0.25, 0, 100, 10_000);
        EqualChoice choice = EqualChoice.ofError(studies());
        assertThat(choice.limit()).isCloseTo(0.1, Offset.offset(1e-6));
        assertThat(choice.points().values()).extracting(StudyPoint::rays).containsExactly(100L, 10_000L);
    }

    @Test
    void withinTime_givenNoPoint_isEmpty() {
        fake.add(FakeStudy.known("caustic-mesh"), -0.5, 0, 1_000);
        assertThat(EqualChoice.withinTime(studies(), 1e-4).points()).isEmpty();
    }
}
