package org.diacaustic.page;

import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Map;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.image.LinearImage;

/** The pictures of a page, each in it once however often it is shown: as a style that elements take by name. */
final class PageImages {
    private final Map<String, String> names = new LinkedHashMap<>();
    private final StringBuilder styles = new StringBuilder();

    /** Whether there is a picture under a key. */
    boolean has(String key) {
        return names.containsKey(key);
    }

    /**
     * Keeps a picture.
     *
     * @param key that no other picture has
     */
    void put(String key, LinearImage picture, Exposure exposure) {
        String name = "p" + names.size();
        names.put(key, name);
        String data = Base64.getEncoder().encodeToString(ImageFiles.bytes(picture, exposure, ImageFormat.PNG));
        styles.append('.')
                .append(name)
                .append("{background-image:url(data:image/png;base64,")
                .append(data)
                .append(");aspect-ratio:")
                .append(picture.width())
                .append('/')
                .append(picture.height())
                .append("}\n");
    }

    /** The name of the style that shows the picture of a key. */
    String style(String key) {
        return names.get(key);
    }

    /** All styles, for the end of the page: text is read before pictures are there. */
    String styles() {
        return styles.toString();
    }
}
