package fieldcal.vision;

import com.google.protobuf.CodedInputStream;
import com.google.protobuf.WireFormat;
import fieldcal.proto.SSL_WrapperPacket;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Decodes the bytes of vision's packets ({@code SSL_WrapperPacket}) to values in SI units.
 *
 * <p>Never throws on bad data: what is unusable is left out and counted by reason. Geometry is sent over and over; as long as its content stays the same, the same object is returned. What some sources split over several messages is put together, see {@link FieldGeometry#updated}. Not thread-safe.
 */
public final class VisionDecoder {
  /** The largest number that counts as a camera's: the league uses 0 … 7, and a damaged packet must not reserve memory for millions of cameras. */
  public static final int MAX_CAMERA_ID = 255;

  /** The largest number that counts as a robot's: the league uses 0 … 15. */
  public static final int MAX_ROBOT_NUMBER = 255;

  /** Coordinates beyond this are no place on a field, m: eight times the largest field of the rules. */
  public static final double MAX_COORDINATE = 100;

  private static final int DETECTION =
      SSL_WrapperPacket.DETECTION_FIELD_NUMBER << 3 | WireFormat.WIRETYPE_LENGTH_DELIMITED;
  private static final int GEOMETRY =
      SSL_WrapperPacket.GEOMETRY_FIELD_NUMBER << 3 | WireFormat.WIRETYPE_LENGTH_DELIMITED;

  private final DecodingCounts counts = new DecodingCounts();
  private final FrameReader frames;
  private final Map<ByteBuffer, Optional<FieldGeometry>> messages = new RecentMessages();
  private Optional<FieldGeometry> geometry = Optional.empty();

  /** The most recent distinct geometry messages, decoded, by their bytes. */
  private static final class RecentMessages
      extends LinkedHashMap<ByteBuffer, Optional<FieldGeometry>> {
    private static final long serialVersionUID = 1;

    /** A source that splits its geometry sends as many as it has cameras; the league has eight at most. */
    private static final int MAX_GEOMETRY_PARTS = 16;

    @Override
    protected boolean removeEldestEntry(Map.Entry<ByteBuffer, Optional<FieldGeometry>> eldest) {
      return size() > MAX_GEOMETRY_PARTS;
    }
  }

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
    Optional<FieldGeometry> message = messages.get(ByteBuffer.wrap(buffer, start, size));
    if (message == null) {
      message = GeometryReader.read(CodedInputStream.newInstance(buffer, start, size), counts);
      messages.put(
          ByteBuffer.wrap(Arrays.copyOfRange(buffer, start, start + size)).asReadOnlyBuffer(),
          message);
    }
    if (message.isEmpty()) {
      return message;
    }
    FieldGeometry next = message.get();
    geometry = Optional.of(geometry.map(known -> known.updated(next)).orElse(next));
    return geometry;
  }
}
