package fieldcal.vision;

import com.google.protobuf.CodedInputStream;
import com.google.protobuf.WireFormat;
import fieldcal.proto.SSL_WrapperPacket;
import java.io.IOException;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/**
 * From the bytes of vision's packets ({@code SSL_WrapperPacket}) to values in SI units.
 *
 * <p>Never throws on bad data: what is unusable is left out and counted by reason. Geometry is sent over and over; the same bytes
 * give the same object. Not thread-safe.
 */
public final class VisionDecoder {
  /** The largest camera number taken for one: the league uses 0 … 7, and a damaged packet must not make room for millions. */
  public static final int MAX_CAMERA_ID = 255;

  /** The largest robot number taken for one: the league uses 0 … 15. */
  public static final int MAX_ROBOT_NUMBER = 255;

  /** Coordinates beyond this are no place on a field, m: eight times the largest field of the rules. */
  public static final double MAX_COORDINATE = 100;

  private static final int DETECTION =
      SSL_WrapperPacket.DETECTION_FIELD_NUMBER << 3 | WireFormat.WIRETYPE_LENGTH_DELIMITED;
  private static final int GEOMETRY =
      SSL_WrapperPacket.GEOMETRY_FIELD_NUMBER << 3 | WireFormat.WIRETYPE_LENGTH_DELIMITED;

  private final DecodingCounts counts = new DecodingCounts();
  private final FrameReader frames;
  private byte[] geometryBytes; // null before the first geometry
  private Optional<FieldGeometry> geometry = Optional.empty();

  /**
   * Creates a decoder.
   *
   * @param epoch the instant that the frames' times count from
   */
  public VisionDecoder(Epoch epoch) {
    frames = new FrameReader(Objects.requireNonNull(epoch, "epoch"), counts);
  }

  /**
   * Decodes a packet.
   *
   * @param packet the packet's bytes
   * @return what is in it; {@link VisionPacket#EMPTY} if nothing usable is
   */
  public VisionPacket decode(byte[] packet) {
    return decode(packet, 0, packet.length);
  }

  /**
   * Decodes a packet that lies within a larger array.
   *
   * @param buffer holds the packet
   * @param offset its first byte
   * @param length its length, bytes
   * @return what is in it; {@link VisionPacket#EMPTY} if nothing usable is
   * @throws IndexOutOfBoundsException if the packet does not lie within the array
   */
  public VisionPacket decode(byte[] buffer, int offset, int length) {
    Objects.checkFromIndexSize(offset, length, buffer.length);
    try {
      CodedInputStream in = CodedInputStream.newInstance(buffer, offset, length);
      VisionFrame frame = null;
      Optional<FieldGeometry> field = Optional.empty();
      for (int tag = in.readTag(); tag != 0; tag = in.readTag()) {
        if (tag == DETECTION) {
          int oldLimit = in.pushLimit(in.readRawVarint32());
          frame = frames.read(in);
          in.checkLastTagWas(0);
          in.popLimit(oldLimit);
        } else if (tag == GEOMETRY) {
          int size = in.readRawVarint32();
          int start = offset + in.getTotalBytesRead();
          in.skipRawBytes(size);
          field = geometry(buffer, start, size);
        } else {
          FrameReader.skip(in, tag);
        }
      }
      if (frame == null && field.isEmpty()) {
        return VisionPacket.EMPTY;
      }
      return new VisionPacket(Optional.ofNullable(frame), field);
    } catch (IOException e) {
      counts.add(DecodingProblem.MALFORMED_PACKET);
      return VisionPacket.EMPTY;
    }
  }

  /**
   * What was left out so far, by reason. Geometry that repeats is counted once.
   *
   * @return the live counts of this decoder
   */
  public DecodingCounts counts() {
    return counts;
  }

  private Optional<FieldGeometry> geometry(byte[] buffer, int start, int size) throws IOException {
    if (geometryBytes == null
        || !Arrays.equals(buffer, start, start + size, geometryBytes, 0, geometryBytes.length)) {
      geometry = GeometryReader.read(CodedInputStream.newInstance(buffer, start, size), counts);
      geometryBytes = Arrays.copyOfRange(buffer, start, start + size);
    }
    return geometry;
  }
}
