package fieldcal.gamelog;

import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;

/** Builds game logs byte by byte, also such as no writer would make. */
final class LogBuilder {
  static final Epoch EPOCH = Epoch.atSecondOf(1_763_712_345.0);

  private final VisionEncoder encoder = new VisionEncoder(EPOCH);
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  LogBuilder() {
    raw("SSL_LOG_FILE".getBytes());
    raw(0, 0, 0, 1);
  }

  LogBuilder frame(VisionFrame frame, double received) {
    return record(received, 4, encoder.encode(VisionPacket.of(frame)));
  }

  LogBuilder frame(VisionFrame frame) {
    return frame(frame, frame.captureTime() + 0.01);
  }

  LogBuilder geometry(FieldGeometry geometry, double received) {
    return record(received, 4, encoder.encode(VisionPacket.of(geometry)));
  }

  LogBuilder record(double received, int type, byte[] payload) {
    header(received, type, payload.length);
    return raw(payload);
  }

  LogBuilder header(double received, int type, int size) {
    return raw(
        ByteBuffer.allocate(16)
            .putLong(EPOCH.unixNanosOf(received))
            .putInt(type)
            .putInt(size)
            .array());
  }

  LogBuilder raw(int... bytes) {
    for (int value : bytes) {
      out.write(value);
    }
    return this;
  }

  LogBuilder raw(byte[] bytes) {
    out.writeBytes(bytes);
    return this;
  }

  int size() {
    return out.size();
  }

  byte[] bytes() {
    return out.toByteArray();
  }

  Path write(Path file) {
    return write(file, bytes());
  }

  static Path write(Path file, byte[] bytes) {
    try {
      return Files.write(file, bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static byte[] gzip(byte[] bytes) {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
      gzip.write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return packed.toByteArray();
  }
}
