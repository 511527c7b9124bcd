package fieldcal.app.replay;

import com.google.protobuf.DescriptorProtos.FileDescriptorSet;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.FileDescriptor;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * Writes an MCAP file with protobuf messages (<a href="https://mcap.dev/spec">mcap.dev/spec</a>): chunks without compression, each with an index, and a summary at the end, so that a player can jump.
 */
final class McapWriter implements Closeable {
  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
  private static final int HEADER = 0x01;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int MESSAGE = 0x05;
  private static final int CHUNK = 0x06;
  private static final int MESSAGE_INDEX = 0x07;
  private static final int CHUNK_INDEX = 0x08;
  private static final int STATISTICS = 0x0B;
  private static final int SUMMARY_OFFSET = 0x0E;
  private static final int DATA_END = 0x0F;

  /** A chunk is closed when it is larger; what the format's own libraries use by default is near. */
  private static final int CHUNK_BYTES = 1 << 20;

  private final OutputStream out;
  private final Map<String, Integer> schemas = new LinkedHashMap<>();
  private final List<Channel> channels = new ArrayList<>();
  private final Record definitions = new Record();
  private final Record chunkIndexes = new Record();
  private final Map<Integer, Record> messageIndexes = new TreeMap<>();
  private Record chunk = new Record();
  private long chunkFirst;
  private long chunkLast;
  private int chunks;
  private long written;
  private long first = Long.MAX_VALUE;
  private long last;

  /** A topic: messages of one type. */
  static final class Channel {
    private final int id;
    private int count;

    Channel(int id) {
      this.id = id;
    }
  }

  McapWriter(OutputStream out) throws IOException {
    this.out = out;
    put(MAGIC);
    Record header = new Record();
    header.string("").string("fieldcal");
    put(HEADER, header);
  }

  /** Opens a topic for messages of a type. */
  Channel channel(String topic, Descriptor type) throws IOException {
    Record defined = new Record();
    Integer schema = schemas.get(type.getFullName());
    if (schema == null) {
      schema = schemas.size() + 1;
      schemas.put(type.getFullName(), schema);
      Record record = new Record();
      record.u16(schema).string(type.getFullName()).string("protobuf");
      record.bytes(set(type).toByteArray());
      defined.record(SCHEMA, record);
    }
    Channel channel = new Channel(channels.size() + 1);
    Record record = new Record();
    record.u16(channel.id).u16(schema).string(topic).string("protobuf").u32(0);
    defined.record(CHANNEL, record);
    channels.add(channel);
    definitions.put(defined.toByteArray());
    chunk.put(defined.toByteArray());
    return channel;
  }

  /** The file that defines a message, after all that it needs. */
  private static FileDescriptorSet set(Descriptor type) {
    Map<String, FileDescriptor> files = new LinkedHashMap<>();
    collect(type.getFile(), files);
    FileDescriptorSet.Builder set = FileDescriptorSet.newBuilder();
    files.values().forEach(f -> set.addFile(f.toProto()));
    return set.build();
  }

  private static void collect(FileDescriptor file, Map<String, FileDescriptor> files) {
    for (FileDescriptor needed : file.getDependencies()) {
      collect(needed, files);
    }
    files.putIfAbsent(file.getName(), file);
  }

  /**
   * Writes a message.
   *
   * @param nanos when it belongs, Unix time in ns, not negative
   */
  void message(Channel channel, long nanos, byte[] data) throws IOException {
    if (messageIndexes.isEmpty()) {
      chunkFirst = nanos;
      chunkLast = nanos;
    }
    chunkFirst = Math.min(chunkFirst, nanos);
    chunkLast = Math.max(chunkLast, nanos);
    first = Math.min(first, nanos);
    last = Math.max(last, nanos);
    messageIndexes.computeIfAbsent(channel.id, id -> new Record()).u64(nanos).u64(chunk.size());
    Record record = new Record();
    record.u16(channel.id).u32(channel.count++).u64(nanos).u64(nanos).put(data);
    chunk.record(MESSAGE, record);
    if (chunk.size() > CHUNK_BYTES) {
      endChunk();
    }
  }

  private void endChunk() throws IOException {
    if (chunk.size() == 0) {
      return;
    }
    byte[] records = chunk.toByteArray();
    boolean empty = messageIndexes.isEmpty();
    long from = empty ? 0 : chunkFirst;
    long to = empty ? 0 : chunkLast;
    long start = written;
    Record record = new Record();
    record.u64(from).u64(to).u64(records.length).u32(crc(records)).string("");
    record.u64(records.length).put(records);
    put(CHUNK, record);
    long length = written - start;
    Record offsets = new Record();
    long indexStart = written;
    for (Map.Entry<Integer, Record> e : messageIndexes.entrySet()) {
      offsets.u16(e.getKey()).u64(written);
      Record index = new Record();
      index.u16(e.getKey()).bytes(e.getValue().toByteArray());
      put(MESSAGE_INDEX, index);
    }
    Record index = new Record();
    index.u64(from).u64(to).u64(start).u64(length).bytes(offsets.toByteArray());
    index.u64(written - indexStart).string("").u64(records.length).u64(records.length);
    chunkIndexes.record(CHUNK_INDEX, index);
    chunks++;
    chunk = new Record();
    messageIndexes.clear();
  }

  /** Writes what is left, and the summary. */
  @Override
  public void close() throws IOException {
    endChunk();
    put(DATA_END, new Record().u32(0));
    long start = written;
    Record summary = new Record();
    Record offsets = new Record();
    long definitionsEnd = start + definitions.size();
    // Schemas and channels stand mixed: one group each is what the format wants.
    Record schemaGroup = group(SCHEMA);
    Record channelGroup = group(CHANNEL);
    summary.put(schemaGroup.toByteArray()).put(channelGroup.toByteArray());
    offset(offsets, SCHEMA, start, schemaGroup.size());
    offset(offsets, CHANNEL, start + schemaGroup.size(), channelGroup.size());
    Record statistics = new Record();
    statistics.record(STATISTICS, statistics());
    offset(offsets, STATISTICS, definitionsEnd, statistics.size());
    summary.put(statistics.toByteArray());
    offset(offsets, CHUNK_INDEX, start + summary.size(), chunkIndexes.size());
    summary.put(chunkIndexes.toByteArray());
    long offsetStart = start + summary.size();
    summary.put(offsets.toByteArray());
    Record footer = new Record();
    footer.u64(start).u64(offsetStart);
    // The checksum covers the summary and the footer up to itself.
    Record checked = new Record();
    checked.put(summary.toByteArray());
    checked.put(new byte[] {FOOTER}).u64(footer.size() + 4).put(footer.toByteArray());
    footer.u32(crc(checked.toByteArray()));
    put(summary.toByteArray());
    put(FOOTER, footer);
    put(MAGIC);
  }

  /** The definitions of one sort. */
  private Record group(int opcode) {
    Record group = new Record();
    ByteBuffer all = ByteBuffer.wrap(definitions.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);
    while (all.hasRemaining()) {
      int start = all.position();
      int found = all.get();
      int length = (int) all.getLong();
      all.position(all.position() + length);
      if (found == opcode) {
        group.put(all.array(), start, all.position() - start);
      }
    }
    return group;
  }

  private static void offset(Record offsets, int opcode, long start, long length) {
    if (length > 0) {
      Record record = new Record();
      record.put(new byte[] {(byte) opcode}).u64(start).u64(length);
      offsets.record(SUMMARY_OFFSET, record);
    }
  }

  private Record statistics() {
    long messages = channels.stream().mapToLong(c -> c.count).sum();
    Record counts = new Record();
    channels.forEach(c -> counts.u16(c.id).u64(c.count));
    Record record = new Record();
    record.u64(messages).u16(schemas.size()).u32(channels.size()).u32(0).u32(0).u32(chunks);
    record.u64(messages == 0 ? 0 : first).u64(last).bytes(counts.toByteArray());
    return record;
  }

  private static int crc(byte[] bytes) {
    CRC32 crc = new CRC32();
    crc.update(bytes);
    return (int) crc.getValue();
  }

  private void put(int opcode, Record record) throws IOException {
    Record whole = new Record();
    whole.record(opcode, record);
    put(whole.toByteArray());
  }

  private void put(byte[] bytes) throws IOException {
    out.write(bytes);
    written += bytes.length;
  }

  /** Bytes as the format orders them: little-endian, strings and lists with their length before them. */
  private static final class Record {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    Record u16(int value) {
      return number(value, Short.BYTES);
    }

    Record u32(int value) {
      return number(value, Integer.BYTES);
    }

    Record u64(long value) {
      return number(value, Long.BYTES);
    }

    private Record number(long value, int size) {
      for (int i = 0; i < size; i++) {
        bytes.write((int) (value >>> (8 * i)));
      }
      return this;
    }

    Record string(String value) {
      return bytes(value.getBytes(StandardCharsets.UTF_8));
    }

    Record bytes(byte[] value) {
      return u32(value.length).put(value);
    }

    Record put(byte[] value) {
      return put(value, 0, value.length);
    }

    Record put(byte[] value, int from, int length) {
      bytes.write(value, from, length);
      return this;
    }

    Record record(int opcode, Record content) {
      bytes.write(opcode);
      u64(content.size());
      return put(content.toByteArray());
    }

    int size() {
      return bytes.size();
    }

    byte[] toByteArray() {
      return bytes.toByteArray();
    }
  }
}
