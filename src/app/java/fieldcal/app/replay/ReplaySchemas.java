package fieldcal.app.replay;

import com.google.protobuf.DescriptorProtos.DescriptorProto;
import com.google.protobuf.DescriptorProtos.EnumDescriptorProto;
import com.google.protobuf.DescriptorProtos.EnumValueDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Label;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Type;
import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.DescriptorValidationException;
import com.google.protobuf.Descriptors.FieldDescriptor;
import com.google.protobuf.Descriptors.FileDescriptor;
import com.google.protobuf.DurationProto;
import com.google.protobuf.DynamicMessage;
import com.google.protobuf.TimestampProto;
import java.util.Arrays;
import java.util.Locale;

/**
 * The messages of a replay besides vision's own: {@code fieldcal.Kick}, {@code fieldcal.PathPoint}, {@code fieldcal.Residual}, and of Foxglove's {@code foxglove.SceneUpdate} (https://github.com/foxglove/foxglove-sdk, {@code
 * schemas/proto}) the fields that draw a kick, with Foxglove's names and numbers. Described here and not in {@code proto/}, since the library does not need them.
 */
final class ReplaySchemas {
  private static final FileDescriptor FIELDCAL =
      build(
          "fieldcal/replay.proto",
          "fieldcal",
          message(
              "Kick",
              "kick 1 uint32",
              "kind 2 string",
              "team 3 string",
              "robot 4 int32",
              "x_m 5 double",
              "y_m 6 double",
              "speed_mps 7 double",
              "direction_deg 8 double",
              "elevation_deg 9 double",
              "rms_mm 10 double",
              "selected 11 bool",
              "rejected_because 12 string"),
          message(
              "PathPoint",
              "kick 1 uint32",
              "t_s 2 double",
              "x_m 3 double",
              "y_m 4 double",
              "z_m 5 double",
              "vx_mps 6 double",
              "vy_mps 7 double",
              "vz_mps 8 double",
              "speed_mps 9 double",
              "phase 10 string"),
          message(
              "Residual",
              "kick 1 uint32",
              "t_s 2 double",
              "camera 3 uint32",
              "x_m 4 double",
              "y_m 5 double",
              "residual_x_mm 6 double",
              "residual_y_mm 7 double",
              "used 8 bool"));

  private static final FileDescriptor FOXGLOVE =
      build(
          "foxglove/SceneUpdate.proto",
          "foxglove",
          message("Vector3", "x 1 double", "y 2 double", "z 3 double"),
          message("Quaternion", "x 1 double", "y 2 double", "z 3 double", "w 4 double"),
          message("Point3", "x 1 double", "y 2 double", "z 3 double"),
          message("Color", "r 1 double", "g 2 double", "b 3 double", "a 4 double"),
          message("Pose", "position 1 .foxglove.Vector3", "orientation 2 .foxglove.Quaternion"),
          message(
              "SpherePrimitive",
              "pose 1 .foxglove.Pose",
              "size 2 .foxglove.Vector3",
              "color 3 .foxglove.Color"),
          message(
                  "LinePrimitive",
                  "type 1 enum.foxglove.LinePrimitive.Type",
                  "pose 2 .foxglove.Pose",
                  "thickness 3 double",
                  "scale_invariant 4 bool",
                  "points 5 repeated.foxglove.Point3",
                  "color 6 .foxglove.Color")
              .toBuilder()
              .addEnumType(
                  EnumDescriptorProto.newBuilder()
                      .setName("Type")
                      .addValue(value("LINE_STRIP", 0))
                      .addValue(value("LINE_LOOP", 1))
                      .addValue(value("LINE_LIST", 2)))
              .build(),
          message(
              "SceneEntity",
              "timestamp 1 .google.protobuf.Timestamp",
              "frame_id 2 string",
              "id 3 string",
              "lifetime 4 .google.protobuf.Duration",
              "frame_locked 5 bool",
              "spheres 9 repeated.foxglove.SpherePrimitive",
              "lines 11 repeated.foxglove.LinePrimitive"),
          message("SceneUpdate", "entities 2 repeated.foxglove.SceneEntity"));

  static final Descriptor KICK = FIELDCAL.findMessageTypeByName("Kick");
  static final Descriptor PATH_POINT = FIELDCAL.findMessageTypeByName("PathPoint");
  static final Descriptor RESIDUAL = FIELDCAL.findMessageTypeByName("Residual");
  static final Descriptor SCENE = FOXGLOVE.findMessageTypeByName("SceneUpdate");

  private ReplaySchemas() {}

  private static EnumValueDescriptorProto value(String name, int number) {
    return EnumValueDescriptorProto.newBuilder().setName(name).setNumber(number).build();
  }

  /** Fields are written "name number type"; a type with a dot is a message. */
  private static DescriptorProto message(String name, String... fields) {
    DescriptorProto.Builder message = DescriptorProto.newBuilder().setName(name);
    for (String field : fields) {
      String[] parts = field.split(" ");
      FieldDescriptorProto.Builder f =
          FieldDescriptorProto.newBuilder()
              .setName(parts[0])
              .setNumber(Integer.parseInt(parts[1]))
              .setLabel(
                  parts[2].startsWith("repeated") ? Label.LABEL_REPEATED : Label.LABEL_OPTIONAL);
      int dot = parts[2].indexOf('.');
      if (dot < 0) {
        f.setType(Type.valueOf("TYPE_" + parts[2].toUpperCase(Locale.ROOT)));
      } else {
        f.setType(parts[2].startsWith("enum") ? Type.TYPE_ENUM : Type.TYPE_MESSAGE);
        f.setTypeName(parts[2].substring(dot));
      }
      message.addField(f);
    }
    return message.build();
  }

  private static FileDescriptor build(String file, String name, DescriptorProto... messages) {
    FileDescriptorProto proto =
        FileDescriptorProto.newBuilder()
            .setName(file)
            .setPackage(name)
            .setSyntax("proto3")
            .addDependency(TimestampProto.getDescriptor().getName())
            .addDependency(DurationProto.getDescriptor().getName())
            .addAllMessageType(Arrays.asList(messages))
            .build();
    FileDescriptor[] needed = {TimestampProto.getDescriptor(), DurationProto.getDescriptor()};
    try {
      return FileDescriptor.buildFrom(proto, needed);
    } catch (DescriptorValidationException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A message from field names and values in turn; a list of messages for a repeated field. */
  static DynamicMessage of(Descriptor type, Object... namesAndValues) {
    DynamicMessage.Builder message = DynamicMessage.newBuilder(type);
    for (int i = 0; i < namesAndValues.length; i += 2) {
      FieldDescriptor field = type.findFieldByName((String) namesAndValues[i]);
      message.setField(field, namesAndValues[i + 1]);
    }
    return message.build();
  }

  /** A message of Foxglove's file. */
  static DynamicMessage foxglove(String name, Object... namesAndValues) {
    return of(FOXGLOVE.findMessageTypeByName(name), namesAndValues);
  }
}
