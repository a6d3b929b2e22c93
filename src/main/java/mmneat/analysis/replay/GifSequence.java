package mmneat.analysis.replay;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import org.jspecify.annotations.Nullable;

/**
 * A writer of an endlessly repeated animated GIF, frame by frame. All frames have the same size.
 *
 * <p>The palette is a fixed colour cube of 6 x 7 x 6. A frame holds only the rectangle that contains all changed
 * pixels; unchanged pixels in it are transparent. This makes the file several times smaller.
 */
final class GifSequence implements AutoCloseable {

    private static final int REDS = 6;
    private static final int GREENS = 7;
    private static final int BLUES = 6;
    private static final int COLOURS = REDS * GREENS * BLUES;
    private static final int TRANSPARENT = COLOURS;
    private static final IndexColorModel PALETTE = palette();
    private static final String FORMAT = "javax_imageio_gif_image_1.0";

    private final ImageWriter writer;
    private final ImageOutputStream stream;

    /** Palette indices of the previous frame, row by row; null before the first frame. */
    private byte @Nullable [] before;

    GifSequence(OutputStream out) throws IOException {
        writer = ImageIO.getImageWritersByFormatName("gif").next();
        stream = ImageIO.createImageOutputStream(out);
        writer.setOutput(stream);
        writer.prepareWriteSequence(null);
    }

    private static IndexColorModel palette() {
        byte[] red = new byte[256];
        byte[] green = new byte[256];
        byte[] blue = new byte[256];
        for (int colour = 0; colour < COLOURS; colour++) {
            red[colour] = (byte) (colour / (GREENS * BLUES) * 255 / (REDS - 1));
            green[colour] = (byte) (colour / BLUES % GREENS * 255 / (GREENS - 1));
            blue[colour] = (byte) (colour % BLUES * 255 / (BLUES - 1));
        }
        return new IndexColorModel(8, 256, red, green, blue, TRANSPARENT);
    }

    /**
     * Adds a frame.
     *
     * @param centiseconds how long the frame is shown, in hundredths of a second
     */
    void add(BufferedImage image, int centiseconds) {
        int width = image.getWidth();
        int height = image.getHeight();
        byte[] now = colours(image);
        int left = width;
        int right = -1;
        int top = height;
        int bottom = -1;
        for (int i = 0; i < now.length; i++) {
            if (before == null || now[i] != before[i]) {
                left = Math.min(left, i % width);
                right = Math.max(right, i % width);
                top = Math.min(top, i / width);
                bottom = Math.max(bottom, i / width);
            }
        }
        if (right < 0) {
            // Nothing changed; one pixel keeps the time.
            left = right = top = bottom = 0;
        }
        BufferedImage part =
                new BufferedImage(right - left + 1, bottom - top + 1, BufferedImage.TYPE_BYTE_INDEXED, PALETTE);
        byte[] pixels = ((DataBufferByte) part.getRaster().getDataBuffer()).getData();
        for (int y = top; y <= bottom; y++) {
            for (int x = left; x <= right; x++) {
                int i = y * width + x;
                boolean isOld = before != null && now[i] == before[i];
                pixels[(y - top) * part.getWidth() + x - left] = isOld ? (byte) TRANSPARENT : now[i];
            }
        }
        write(part, left, top, centiseconds);
        before = now;
    }

    private static byte[] colours(BufferedImage image) {
        int[] rgb = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        byte[] colours = new byte[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            int red = nearest(rgb[i] >> 16 & 255, REDS);
            int green = nearest(rgb[i] >> 8 & 255, GREENS);
            int blue = nearest(rgb[i] & 255, BLUES);
            colours[i] = (byte) ((red * GREENS + green) * BLUES + blue);
        }
        return colours;
    }

    private static int nearest(int value, int levels) {
        return (value * (levels - 1) + 127) / 255;
    }

    private void write(BufferedImage part, int left, int top, int centiseconds) {
        try {
            IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(part), null);
            describe(metadata, left, top, centiseconds);
            writer.writeToSequence(new IIOImage(part, null, metadata), null);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void describe(IIOMetadata metadata, int left, int top, int centiseconds) throws IIOInvalidTreeException {
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        IIOMetadataNode place = child(root, "ImageDescriptor");
        place.setAttribute("imageLeftPosition", String.valueOf(left));
        place.setAttribute("imageTopPosition", String.valueOf(top));
        IIOMetadataNode control = child(root, "GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "TRUE");
        control.setAttribute("transparentColorIndex", String.valueOf(TRANSPARENT));
        control.setAttribute("delayTime", String.valueOf(centiseconds));
        if (before == null) {
            IIOMetadataNode endless = new IIOMetadataNode("ApplicationExtension");
            endless.setAttribute("applicationID", "NETSCAPE");
            endless.setAttribute("authenticationCode", "2.0");
            endless.setUserObject(new byte[] {1, 0, 0});
            child(root, "ApplicationExtensions").appendChild(endless);
        }
        metadata.setFromTree(FORMAT, root);
    }

    private static IIOMetadataNode child(IIOMetadataNode parent, String name) {
        if (parent.getElementsByTagName(name).getLength() == 0) {
            parent.appendChild(new IIOMetadataNode(name));
        }
        return (IIOMetadataNode) parent.getElementsByTagName(name).item(0);
    }

    @Override
    public void close() throws IOException {
        writer.endWriteSequence();
        stream.close();
        writer.dispose();
    }
}
