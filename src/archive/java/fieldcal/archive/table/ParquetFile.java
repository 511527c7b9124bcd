package fieldcal.archive.table;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.parquet.column.ParquetProperties;
import org.apache.parquet.conf.PlainParquetConfiguration;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.SimpleGroup;
import org.apache.parquet.example.data.simple.convert.GroupRecordConverter;
import org.apache.parquet.format.FileMetaData;
import org.apache.parquet.format.Util;
import org.apache.parquet.hadoop.ParquetFileReader;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.hadoop.example.ExampleParquetWriter;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import org.apache.parquet.io.ColumnIOFactory;
import org.apache.parquet.io.LocalInputFile;
import org.apache.parquet.io.LocalOutputFile;
import org.apache.parquet.io.RecordReader;
import org.apache.parquet.schema.LogicalTypeAnnotation;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Type;
import org.apache.parquet.schema.Types;

/** Writes and reads one file of a table. The same rows give the same bytes: no clock, no name and no random number enters a file. */
public final class ParquetFile {
  private static final String LIST = "list";
  private static final String ELEMENT = "element";

  /** A file ends with this many bytes that name the format. */
  private static final int MAGIC = 4;

  /** They follow the length of the footer. */
  private static final int TRAILER = Integer.BYTES + MAGIC;

  private ParquetFile() {}

  /**
   * Writes a file.
   *
   * @param table its columns
   * @param rows in order
   * @param file replaced when it is there
   * @throws IOException when it cannot be written
   * @throws IllegalArgumentException when a value is missing that may not be
   */
  public static void write(Table table, List<Row> rows, Path file) throws IOException {
    MessageType schema = schema(table);
    Files.deleteIfExists(file);
    try (ParquetWriter<Group> writer =
        ExampleParquetWriter.builder(new LocalOutputFile(file))
            .withConf(new PlainParquetConfiguration())
            .withType(schema)
            .withWriterVersion(ParquetProperties.WriterVersion.PARQUET_1_0)
            .withCompressionCodec(CompressionCodecName.SNAPPY)
            .build()) {
      for (Row row : rows) {
        writer.write(group(schema, row));
      }
    }
    orderEncodings(file);
  }

  /** The footer lists the encodings of a column in the order of a hash set of enums, which is another one in every process. */
  private static void orderEncodings(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    ByteBuffer end =
        ByteBuffer.wrap(bytes, bytes.length - TRAILER, TRAILER).order(ByteOrder.LITTLE_ENDIAN);
    int begin = bytes.length - TRAILER - end.getInt();
    FileMetaData footer =
        Util.readFileMetaData(new ByteArrayInputStream(bytes, begin, bytes.length - begin));
    footer
        .getRow_groups()
        .forEach(
            group ->
                group
                    .getColumns()
                    .forEach(column -> column.getMeta_data().getEncodings().sort(null)));
    ByteArrayOutputStream ordered = new ByteArrayOutputStream();
    Util.writeFileMetaData(footer, ordered);
    try (OutputStream out = Files.newOutputStream(file)) {
      out.write(bytes, 0, begin);
      ordered.writeTo(out);
      out.write(
          ByteBuffer.allocate(Integer.BYTES)
              .order(ByteOrder.LITTLE_ENDIAN)
              .putInt(ordered.size())
              .array());
      out.write(bytes, bytes.length - MAGIC, MAGIC);
    }
  }

  /**
   * Reads a file.
   *
   * @param table its columns
   * @param file written by {@link #write}
   * @return its rows
   * @throws IOException when it cannot be read, or is none of this table
   */
  public static List<Row> read(Table table, Path file) throws IOException {
    List<Row> rows = new ArrayList<>();
    try (ParquetFileReader reader = ParquetFileReader.open(new LocalInputFile(file))) {
      MessageType schema = reader.getFileMetaData().getSchema();
      if (!schema.equals(schema(table))) {
        throw new IOException(file + ": is not a file of table " + table.name());
      }
      for (var pages = reader.readNextRowGroup();
          pages != null;
          pages = reader.readNextRowGroup()) {
        RecordReader<Group> records =
            new ColumnIOFactory()
                .getColumnIO(schema)
                .getRecordReader(pages, new GroupRecordConverter(schema));
        for (long i = 0; i < pages.getRowCount(); i++) {
          rows.add(row(table, records.read()));
        }
      }
    } catch (RuntimeException damaged) {
      throw new IOException(file + ": cannot be read: " + damaged.getMessage(), damaged);
    }
    return rows;
  }

  static MessageType schema(Table table) {
    Types.MessageTypeBuilder builder = Types.buildMessage();
    table.columns().forEach(column -> builder.addField(type(column)));
    return builder.named(table.name());
  }

  private static Type type(Column column) {
    Type.Repetition repetition =
        column.nullable() ? Type.Repetition.OPTIONAL : Type.Repetition.REQUIRED;
    String name = column.name();
    return switch (column.type()) {
      case BOOLEAN -> Types.primitive(PrimitiveTypeName.BOOLEAN, repetition).named(name);
      case INT -> Types.primitive(PrimitiveTypeName.INT32, repetition).named(name);
      case LONG -> Types.primitive(PrimitiveTypeName.INT64, repetition).named(name);
      case DOUBLE -> Types.primitive(PrimitiveTypeName.DOUBLE, repetition).named(name);
      case TEXT ->
          Types.primitive(PrimitiveTypeName.BINARY, repetition)
              .as(LogicalTypeAnnotation.stringType())
              .named(name);
      case TIME ->
          Types.primitive(PrimitiveTypeName.INT64, repetition)
              .as(LogicalTypeAnnotation.timestampType(true, LogicalTypeAnnotation.TimeUnit.MICROS))
              .named(name);
      case INTS -> Types.list(repetition).requiredElement(PrimitiveTypeName.INT32).named(name);
    };
  }

  private static Group group(MessageType schema, Row row) {
    SimpleGroup group = new SimpleGroup(schema);
    List<Column> columns = row.table().columns();
    for (int i = 0; i < columns.size(); i++) {
      Object value = row.get(i);
      if (value == null) {
        if (!columns.get(i).nullable()) {
          throw new IllegalArgumentException(
              "column " + columns.get(i).name() + " of " + row.table().name() + " is missing");
        }
        continue;
      }
      switch (columns.get(i).type()) {
        case BOOLEAN -> group.add(i, (Boolean) value);
        case INT -> group.add(i, (Integer) value);
        case LONG, TIME -> group.add(i, (Long) value);
        case DOUBLE -> group.add(i, (Double) value);
        case TEXT -> group.add(i, (String) value);
        case INTS -> {
          Group list = group.addGroup(i);
          for (Object element : (List<?>) value) {
            list.addGroup(LIST).add(ELEMENT, (Integer) element);
          }
        }
        default -> throw new IllegalStateException("no such type: " + columns.get(i).type());
      }
    }
    return group;
  }

  private static Row row(Table table, Group group) {
    Row row = table.row();
    for (int i = 0; i < table.columns().size(); i++) {
      Column column = table.columns().get(i);
      if (group.getFieldRepetitionCount(i) > 0) {
        row.set(column.name(), value(column, group, i));
      }
    }
    return row;
  }

  private static Object value(Column column, Group group, int i) {
    return switch (column.type()) {
      case BOOLEAN -> group.getBoolean(i, 0);
      case INT -> group.getInteger(i, 0);
      case LONG, TIME -> group.getLong(i, 0);
      case DOUBLE -> group.getDouble(i, 0);
      case TEXT -> group.getString(i, 0);
      case INTS -> {
        Group list = group.getGroup(i, 0);
        List<Integer> elements = new ArrayList<>();
        for (int k = 0; k < list.getFieldRepetitionCount(0); k++) {
          elements.add(list.getGroup(0, k).getInteger(ELEMENT, 0));
        }
        yield elements;
      }
    };
  }
}
