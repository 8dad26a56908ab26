package org.diacaustic.fault;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.image.LinearImage;

/** Faults of files that a scene names. */
final class FileFaults {
    private static final String IMAGE = "^scene\\.yaml:5:\\d+: materials\\.grey\\.diffuse\\.image\\.file: ";

    private FileFaults() {}

    static void addTo(FaultOperations operations) {
        operations
                .add(
                        "missingfile",
                        "A texture, a bump image, a mesh, the scene itself that is not there or is a folder: exit code 3 with the"
                                + " whole path.",
                        (bench, asked, checks) -> missing(bench))
                .add(
                        "traversal",
                        "Names with .., absolute names, and symbolic links that lead out of the scene's folder, for textures and"
                                + " meshes: exit code 2, without a word of the content, also if the file is not there; with"
                                + " --allow-outside it is read.",
                        (bench, asked, checks) -> traversal(bench))
                .add(
                        "imagebomb",
                        "Headers of PNG, TGA, HDR, PFM and BMP that promise gigabytes and more, with -Xmx256m: exit code 4 within 2 s.",
                        (bench, asked, checks) -> bombs(bench))
                .add(
                        "brokenimage",
                        "Wrong checksums, unknown filters, files that end early, text, nothing, no size, for all formats: exit code 3"
                                + " with the name of the file.",
                        (bench, asked, checks) -> broken(bench))
                .add(
                        "meshfaults",
                        "OBJ, PLY and STL with indices out of range, coordinates that are no numbers, ends that come early: exit code 2"
                                + " and the line, or the vertex or face of a binary file; triangles without area are left out with a warning.",
                        (bench, asked, checks) -> MeshFaults.meet(bench));
    }

    private static String textured(String file) {
        return FaultScene.with(FaultScene.GREY, "diffuse: {image: {file: '" + file + "'}}");
    }

    private static String meshed(String file) {
        return FaultScene.withObject("mesh", "file: '" + file + "'");
    }

    private static void missing(FaultBench bench) throws IOException, InterruptedException {
        Path folder = bench.folder().toRealPath();
        Files.createDirectory(folder.resolve("folder.png"));
        bench.refuses("a texture", textured("nofile.png"), 3, IMAGE + "no such file: " + folder.resolve("nofile.png"));
        bench.refuses("a folder on the way", textured("no/a.png"), 3, "no such file: " + folder.resolve("no/a.png"));
        bench.refuses("a folder for a texture", textured("folder.png"), 3, IMAGE + "expected a file, found a folder: ");
        bench.refuses(
                "a mesh",
                meshed("no.obj"),
                3,
                "objects\\[2\\]\\.mesh\\.file: no such file: " + folder.resolve("no.obj"));
        bench.refuses(
                "a bump image",
                FaultScene.with(FaultScene.GREY, "diffuse: 1, bump-image: {file: no.png, height: 1}"),
                3,
                "no such file: " + folder.resolve("no.png"));
        bench.refused("the scene", bench.program().run("render", "no.yaml", "-o", "out.png"), 3, "no such file: ");
        bench.refused(
                "a folder for the scene",
                bench.program().run("render", "folder.png", "-o", "out.png"),
                3,
                "expected a file, found a folder: ");
    }

    private static void traversal(FaultBench bench) throws IOException, InterruptedException {
        String outside = "the file lies outside the scene's folder, which is not allowed: [^\\n]*$";
        Path secret = Files.writeString(bench.folder().resolveSibling("secret.png"), "PASSWORD");
        Files.createSymbolicLink(bench.folder().resolve("link.png"), secret);
        Files.createSymbolicLink(bench.folder().resolve("up"), bench.folder().getParent());
        Path inside = Files.createDirectory(bench.folder().resolve("inside"));
        Files.write(inside.resolve("sound.png"), BrokenPictures.smallPng(0));
        for (String name : new String[] {
            "../secret.png",
            "../none.png",
            "../../../../../../../../etc/passwd",
            "/etc/passwd",
            secret.toString(),
            "link.png",
            "up/secret.png",
            "inside/../../secret.png",
            "./.././secret.png"
        }) {
            bench.refuses(
                    "a texture " + name.replace(secret.toString(), "by its whole path"),
                    textured(name),
                    2,
                    IMAGE + outside);
        }
        bench.refuses("a mesh", meshed("../../../../../../../../etc/passwd"), 2, outside);
        bench.renders("a texture in a folder below", textured("inside/../inside/sound.png"), "");
        bench.scene(textured("../secret.png"));
        bench.refused(
                "what is no picture, with --allow-outside",
                bench.render("--allow-outside"),
                3,
                IMAGE + "(?!.*PASSWORD).*secret\\.png");
        Files.write(secret, BrokenPictures.smallPng(0));
        bench.rendered("a picture, with --allow-outside", bench.render("--allow-outside"), "");
    }

    private static void bombs(FaultBench bench) throws IOException, InterruptedException {
        Map<String, byte[]> bombs = new LinkedHashMap<>();
        bombs.put("50000x50000.png", BrokenPictures.greyPng(50_000, 50_000));
        bombs.put("65500x65500.png", BrokenPictures.deepPng(65_500, 65_500));
        bombs.put("2147483647x2147483647.png", BrokenPictures.greyPng(Integer.MAX_VALUE, Integer.MAX_VALUE));
        bombs.put("2147483647x1.png", BrokenPictures.greyPng(Integer.MAX_VALUE, 1));
        bombs.put("65535x65535.tga", BrokenPictures.targaHeader(65_535, 65_535));
        bombs.put(
                "1000000x1000000.hdr",
                BrokenPictures.ascii("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 1000000\n\2\2"));
        bombs.put("200000x200000.pfm", BrokenPictures.ascii("PF\n200000 200000\n-1.0\n0000"));
        for (Map.Entry<String, byte[]> bomb : bombs.entrySet()) {
            bench.write(bomb.getKey(), bomb.getValue());
            bench.scene(textured(bomb.getKey()));
            ProgramRun run =
                    FaultBench.within(2, () -> bench.render(bench.program().with("-Xmx256m")));
            bench.refused(bomb.getKey(), run, 4, IMAGE + ".*" + bomb.getKey() + ": .*bytes", 2);
        }
    }

    private static void broken(FaultBench bench) throws IOException, InterruptedException {
        Map<String, byte[]> pictures = new LinkedHashMap<>();
        pictures.put("checksum.png", BrokenPictures.smallPng(1));
        pictures.put("half.png", BrokenPictures.half(BrokenPictures.smallPng(0)));
        pictures.put("data.png", BrokenPictures.greyPng(40, 40));
        pictures.put("filter.png", BrokenPictures.unknownFilter());
        pictures.put("zero.png", BrokenPictures.greyPng(0, 2));
        pictures.put("text.png", BrokenPictures.ascii("no picture"));
        pictures.put("empty.png", new byte[0]);
        pictures.put("empty.tga", new byte[0]);
        pictures.put("header.tga", BrokenPictures.half(BrokenPictures.targaHeader(40, 40)));
        pictures.put("size.hdr", BrokenPictures.ascii("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y five +X 5\n"));
        pictures.put("scale.pfm", BrokenPictures.ascii("PF\n2 2\nnan\n"));
        pictures.put("half.jpg", BrokenPictures.half(jpeg()));
        LinearImage picture = new LinearImage(9, 9);
        for (ImageFormat format : ImageFormat.values()) {
            byte[] whole = ImageFiles.bytes(picture, Exposure.fixed(1), format);
            pictures.put("early." + format.ending(), BrokenPictures.half(whole));
        }
        for (Map.Entry<String, byte[]> one : pictures.entrySet()) {
            bench.write(one.getKey(), one.getValue());
            bench.refuses(one.getKey(), textured(one.getKey()), 3, IMAGE + ".*" + one.getKey());
        }
    }

    private static byte[] jpeg() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(new java.awt.image.BufferedImage(40, 40, java.awt.image.BufferedImage.TYPE_INT_RGB), "jpg", out);
        return out.toByteArray();
    }
}
