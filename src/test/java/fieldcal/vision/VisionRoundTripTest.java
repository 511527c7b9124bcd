package fieldcal.vision;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.protobuf.InvalidProtocolBufferException;
import com.google.protobuf.UnknownFieldSet;
import fieldcal.camera.CameraCalibration;
import fieldcal.proto.Referee;
import fieldcal.proto.SSL_WrapperPacket;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class VisionRoundTripTest {
  private static final Epoch EPOCH = Epoch.atSecondOf(1_763_712_345.678);

  private final VisionEncoder encoder = new VisionEncoder(EPOCH);
  private final VisionDecoder decoder = new VisionDecoder(EPOCH);

  static LongStream seeds() {
    return LongStream.range(0, 200);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void packetsComeBackAsTheyWere(long seed) {
    VisionSamples samples = new VisionSamples(seed);
    VisionPacket packet =
        new VisionPacket(
            seed % 3 == 0 ? Optional.empty() : Optional.of(samples.frame()),
            seed % 3 == 1 ? Optional.empty() : Optional.of(samples.geometry()));

    assertThat(decoder.decode(encoder.encode(packet))).isEqualTo(packet);
    assertThat(decoder.counts().asMap()).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void bytesComeBackAsTheyWere(long seed) throws InvalidProtocolBufferException {
    VisionSamples samples = new VisionSamples(seed);
    byte[] bytes =
        encoder.encode(
            new VisionPacket(Optional.of(samples.frame()), Optional.of(samples.geometry())));

    assertThat(encoder.encode(decoder.decode(bytes))).isEqualTo(bytes);
    assertThat(SSL_WrapperPacket.parseFrom(bytes).toByteArray()).isEqualTo(bytes);
  }

  @Test
  void readsWhatTheGeneratedMessagesRead() throws InvalidProtocolBufferException {
    VisionFrame frame = new VisionSamples(7).frame(3, 99, 12.5);
    byte[] bytes = encoder.encode(VisionPacket.of(frame));
    var message = SSL_WrapperPacket.parseFrom(bytes).getDetection();

    assertThat(message.getTCapture()).isEqualTo(1_763_712_357.5);
    assertThat(message.getCameraId()).isEqualTo(3);
    assertThat(message.getFrameNumber()).isEqualTo(99);
    assertThat(message.getBallsCount()).isEqualTo(frame.balls().size());
    for (int i = 0; i < frame.balls().size(); i++) {
      assertThat(message.getBalls(i).getX() / 1000.0).isEqualTo(frame.balls().get(i).x());
      assertThat(message.getBalls(i).hasZ()).isEqualTo(frame.balls().get(i).hasHeight());
    }
  }

  @Test
  void quaternionOrderAndNegativeDistortionSurvive() {
    CameraCalibration camera =
        new CameraCalibration(
            4, 500, 390, 290, -0.25, 0.125, 0.25, 0.5, -0.75, 1.5, -2.5, 4, 1, -2, 4.5, 780, 580);
    var message = VisionEncoder.toMessage(camera);

    assertThat(List.of(message.getQ0(), message.getQ1(), message.getQ2(), message.getQ3()))
        .containsExactly(0.125f, 0.25f, 0.5f, -0.75f);
    assertThat(message.getDistortion()).isEqualTo(-0.25f);
    assertThat(message.getTx()).isEqualTo(1500f);
    assertThat(message.getDerivedCameraWorldTz()).isEqualTo(4500f);
    FieldGeometry geometry = FieldGeometry.of(9, 6, 1, 0.18, 0.3, List.of(camera));
    assertThat(decoder.decode(encoder.encode(VisionPacket.of(geometry))).geometry().get().cameras())
        .containsExactly(camera);
  }

  @Test
  void unknownFieldsSurviveInMessages() throws InvalidProtocolBufferException {
    UnknownFieldSet future =
        UnknownFieldSet.newBuilder()
            .addField(99, UnknownFieldSet.Field.newBuilder().addVarint(42).build())
            .build();
    VisionSamples samples = new VisionSamples(1);
    SSL_WrapperPacket.Builder packet =
        encoder
            .toMessage(
                new VisionPacket(Optional.of(samples.frame()), Optional.of(samples.geometry())))
            .toBuilder();
    packet.setUnknownFields(future);
    packet.getDetectionBuilder().setUnknownFields(future);
    packet.getGeometryBuilder().setUnknownFields(future);
    packet.getGeometryBuilder().getFieldBuilder().setUnknownFields(future);
    packet.getGeometryBuilder().getModelsBuilder().setUnknownFields(future);
    byte[] bytes = packet.build().toByteArray();

    assertThat(SSL_WrapperPacket.parseFrom(bytes).toByteArray()).isEqualTo(bytes);
    assertThat(decoder.decode(bytes).frame()).contains(new VisionSamples(1).frame());
    assertThat(decoder.counts().total()).isZero();
  }

  @Test
  void retiredRefereeFieldsSurvive() throws InvalidProtocolBufferException {
    Referee referee =
        Referee.newBuilder()
            .setPacketTimestamp(1)
            .setCommand(Referee.Command.HALT)
            .setStage(Referee.Stage.NORMAL_FIRST_HALF)
            .setUnknownFields(
                UnknownFieldSet.newBuilder()
                    .addField(11, UnknownFieldSet.Field.newBuilder().addVarint(7).build())
                    .build())
            .buildPartial();

    Referee back = Referee.newBuilder().mergeFrom(referee.toByteArray()).buildPartial();

    assertThat(back.getUnknownFields().getField(11).getVarintList()).containsExactly(7L);
    assertThat(back).isEqualTo(referee);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void publishedModelsComeBackInBothForms(long seed) {
    FieldGeometry geometry = new VisionSamples(seed).geometry();
    BallModels models = new BallModels(geometry.flat(), geometry.chip());
    if (models.equals(BallModels.NONE)) {
      return;
    }

    assertThat(BallModels.fromFile(models.toBytes())).isEqualTo(models);
    assertThat(BallModels.fromFile(models.toText().getBytes())).isEqualTo(models);
    assertThat(BallModels.fromFile(("\n" + models.toText()).getBytes())).isEqualTo(models);
  }
}
