package org.diacaustic.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class PixelFontTest {

    @Test
    void isSet_givenLettersAndDigits_areAllDifferent() {
        Set<String> shapes = new HashSet<>();
        String characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789,.-+%()/:=";
        for (char character : characters.toCharArray()) {
            StringBuilder shape = new StringBuilder();
            for (int i = 0; i < PixelFont.WIDTH * PixelFont.HEIGHT; i++) {
                shape.append(PixelFont.isSet(character, i / PixelFont.WIDTH, i % PixelFont.WIDTH) ? '#' : ' ');
            }
            assertThat(shape.toString()).as("%s", character).contains("#");
            shapes.add(shape.toString());
        }
        assertThat(shapes).hasSize(characters.length());
        assertThat(PixelFont.isSet('a', 0, 2)).isEqualTo(PixelFont.isSet('A', 0, 2));
    }
}
