package fieldcal.app.replay;

import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.DescriptorProtos.FileDescriptorSet;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.FileDescriptor;
import com.google.protobuf.DynamicMessage;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;

/** A small MCAP reader, written from the specification (mcap.dev/spec) and sharing nothing with the writer. */
final class McapReader {
  private static final byte[] MAGIC = {(byte) 0x89, 0x4D, 0x43, 0x41, 0x50, 0x30, 0x0D, 0x0A};

  private final byte[] file;
  private final Map<Integer, Descriptor> schemas = new HashMap<>();
  private final Map<Integer, Integer> schemaOf = new HashMap<>();
  final Map<Integer, String> topics = new LinkedHashMap<>();
  final List<Message> messages = new ArrayList<>();

  /** Messages that the indexes lead to, by topic and time. */
  int indexed;

  long countInStatistics;

  record Message(String topic, long logTime, DynamicMessage content) {
    Object get(String field) {
      return content.getField(content.getDescriptorForType().findFieldByName(field));
    }

    double number(String field) {
      return ((Number) get(field)).doubleValue();
    }
  }

  McapReader(byte[] file) throws Exception {
    this.file = file;
    require(Arrays.equals(MAGIC, Arrays.copyOf(file, 8)), "magic at the beginning");
    require(
        Arrays.equals(MAGIC, Arrays.copyOfRange(file, file.length - 8, file.length)),
        "magic at the end");
    records(buffer(8, file.length - 8), false);
    summary();
  }

  private static void require(boolean holds, String what) {
    if (!holds) {
      throw new AssertionError("no valid MCAP: " + what);
    }
  }

  private ByteBuffer buffer(int from, int to) {
    return ByteBuffer.wrap(file, from, to - from).slice().order(ByteOrder.LITTLE_ENDIAN);
  }

  private static String string(ByteBuffer in) {
    byte[] bytes = new byte[in.getInt()];
    in.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private static ByteBuffer part(ByteBuffer in, int length) {
    ByteBuffer part = in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN);
    in.position(in.position() + length);
    return part;
  }

  private void records(ByteBuffer in, boolean inChunk) throws Exception {
    boolean ended = false;
    while (in.hasRemaining()) {
      int opcode = in.get();
      ByteBuffer record = part(in, (int) in.getLong());
      switch (opcode) {
        case 0x01 -> require(!inChunk, "a header in a chunk");
        case 0x03 -> schema(record);
        case 0x04 -> channel(record);
        case 0x05 -> {
          require(inChunk, "a message outside a chunk");
          message(record);
        }
        case 0x06 -> chunk(record);
        case 0x07, 0x08, 0x0B, 0x0E -> require(!inChunk, "an index in a chunk");
        case 0x0F -> ended = true;
        case 0x02 -> require(ended && !in.hasRemaining(), "footer");
        default -> throw new AssertionError("opcode " + opcode);
      }
    }
  }

  private void schema(ByteBuffer record) throws Exception {
    int id = Short.toUnsignedInt(record.getShort());
    String name = string(record);
    require(string(record).equals("protobuf"), "schema encoding");
    FileDescriptorSet set = FileDescriptorSet.parseFrom(part(record, record.getInt()));
    Map<String, FileDescriptor> files = new HashMap<>();
    Descriptor found = null;
    for (FileDescriptorProto proto : set.getFileList()) {
      FileDescriptor[] needed =
          proto.getDependencyList().stream().map(files::get).toArray(FileDescriptor[]::new);
      FileDescriptor built = FileDescriptor.buildFrom(proto, needed);
      files.put(proto.getName(), built);
      for (Descriptor type : built.getMessageTypes()) {
        found = type.getFullName().equals(name) ? type : found;
      }
    }
    require(found != null, "schema " + name);
    schemas.put(id, found);
  }

  private void channel(ByteBuffer record) {
    int id = Short.toUnsignedInt(record.getShort());
    schemaOf.put(id, Short.toUnsignedInt(record.getShort()));
    topics.put(id, string(record));
    require(string(record).equals("protobuf"), "message encoding");
  }

  private void message(ByteBuffer record) throws Exception {
    int channel = Short.toUnsignedInt(record.getShort());
    record.getInt();
    long logTime = record.getLong();
    record.getLong();
    byte[] data = new byte[record.remaining()];
    record.get(data);
    messages.add(
        new Message(
            topics.get(channel),
            logTime,
            DynamicMessage.parseFrom(schemas.get(schemaOf.get(channel)), data)));
  }

  private void chunk(ByteBuffer record) throws Exception {
    long from = record.getLong();
    long to = record.getLong();
    long size = record.getLong();
    int crc = record.getInt();
    require(string(record).isEmpty(), "compression");
    ByteBuffer content = part(record, (int) record.getLong());
    require(content.remaining() == size, "size of a chunk");
    CRC32 computed = new CRC32();
    computed.update(content.duplicate());
    require((int) computed.getValue() == crc, "checksum of a chunk");
    int before = messages.size();
    records(content, true);
    for (Message m : messages.subList(before, messages.size())) {
      require(m.logTime() >= from && m.logTime() <= to, "time of a message in its chunk");
    }
  }

  /** Follows every index to its message. */
  private void summary() {
    ByteBuffer footer = buffer(file.length - 8 - 20, file.length - 8);
    int start = (int) footer.getLong();
    int offsetStart = (int) footer.getLong();
    int crc = footer.getInt();
    CRC32 computed = new CRC32();
    computed.update(file, start, file.length - 8 - 4 - start);
    require((int) computed.getValue() == crc, "checksum of the summary");
    ByteBuffer in = buffer(start, offsetStart);
    while (in.hasRemaining()) {
      int opcode = in.get();
      ByteBuffer record = part(in, (int) in.getLong());
      if (opcode == 0x08) {
        record.getLong();
        record.getLong();
        int chunk = (int) record.getLong();
        record.getLong();
        ByteBuffer offsets = part(record, record.getInt());
        while (offsets.hasRemaining()) {
          follow(chunk, Short.toUnsignedInt(offsets.getShort()), (int) offsets.getLong());
        }
      } else if (opcode == 0x0B) {
        countInStatistics = record.getLong();
      }
    }
    ByteBuffer groups = buffer(offsetStart, file.length - 8 - 29);
    while (groups.hasRemaining()) {
      require(groups.get() == 0x0E, "summary offset");
      ByteBuffer record = part(groups, (int) groups.getLong());
      int opcode = record.get();
      require(file[(int) record.getLong()] == opcode, "group of opcode " + opcode);
    }
  }

  private void follow(int chunk, int channel, int indexOffset) {
    require(file[indexOffset] == 0x07, "message index");
    ByteBuffer record = buffer(indexOffset + 9, file.length);
    require(Short.toUnsignedInt(record.getShort()) == channel, "channel of a message index");
    // Records of a chunk begin after opcode, length, three times, checksum, no compression, length.
    int content = chunk + 9 + 24 + 4 + 4 + 8;
    ByteBuffer entries = part(record, record.getInt());
    while (entries.hasRemaining()) {
      long time = entries.getLong();
      int at = content + (int) entries.getLong();
      require(file[at] == 0x05, "indexed message");
      ByteBuffer message = buffer(at + 9, file.length);
      require(Short.toUnsignedInt(message.getShort()) == channel, "channel of a message");
      message.getInt();
      require(message.getLong() == time, "time of an indexed message");
      indexed++;
    }
  }
}
