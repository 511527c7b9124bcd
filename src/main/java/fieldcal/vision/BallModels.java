package fieldcal.vision;

import com.google.protobuf.InvalidProtocolBufferException;
import com.google.protobuf.TextFormat;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.proto.SSL_BallModelChipFixedLoss;
import fieldcal.proto.SSL_BallModelStraightTwoPhase;
import fieldcal.proto.SSL_GeometryModels;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.Optional;

/**
 * The ball models that a team publishes ({@code SSL_GeometryModels}), and their two written forms: the message's bytes and
 * protobuf's text.
 *
 * @param flat model of flat kicks
 * @param chip model of chip kicks; the message has no {@code accRoll} for it, see {@link #fromMessage}
 */
public record BallModels(Optional<FlatModel> flat, Optional<ChipModel> chip) {
  /** No model at all. */
  public static final BallModels NONE = new BallModels(Optional.empty(), Optional.empty());

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException if one is null
   */
  public BallModels {
    Objects.requireNonNull(flat, "flat");
    Objects.requireNonNull(chip, "chip");
  }

  /**
   * Decodes the message. A chip model rolls out with the flat model's {@code accRoll}; without a flat model, with the typical one.
   *
   * @param message the message
   * @return its models
   * @throws IllegalArgumentException if a model is incomplete or a value is out of its range, with the value
   */
  public static BallModels fromMessage(SSL_GeometryModels message) {
    Optional<FlatModel> flat =
        message.hasStraightTwoPhase()
            ? Optional.of(flat(message.getStraightTwoPhase()))
            : Optional.empty();
    Optional<ChipModel> chip =
        message.hasChipFixedLoss()
            ? Optional.of(chip(message.getChipFixedLoss(), flat))
            : Optional.empty();
    return new BallModels(flat, chip);
  }

  /**
   * From a file, binary or text.
   *
   * @param content the file's bytes
   * @return the models in it
   * @throws IllegalArgumentException if it is neither form, holds no model, or a value is out of its range; the message says which
   */
  public static BallModels fromFile(byte[] content) {
    SSL_GeometryModels message = parse(content);
    BallModels models = fromMessage(message);
    if (models.equals(NONE)) {
      throw new IllegalArgumentException("holds no ball model (SSL_GeometryModels)");
    }
    return models;
  }

  /**
   * The message.
   *
   * @return with the models that are present
   */
  public SSL_GeometryModels toMessage() {
    SSL_GeometryModels.Builder message = SSL_GeometryModels.newBuilder();
    flat.ifPresent(
        model ->
            message
                .getStraightTwoPhaseBuilder()
                .setAccSlide(model.accSlide())
                .setAccRoll(model.accRoll())
                .setKSwitch(model.kSwitch()));
    chip.ifPresent(
        model ->
            message
                .getChipFixedLossBuilder()
                .setDampingXyFirstHop(model.dampingXyFirstHop())
                .setDampingXyOtherHops(model.dampingXyOtherHops())
                .setDampingZ(model.dampingZ()));
    return message.build();
  }

  /**
   * The binary form.
   *
   * @return the message's bytes
   */
  public byte[] toBytes() {
    return toMessage().toByteArray();
  }

  /**
   * The text form, for people and configuration files.
   *
   * @return protobuf's text format
   */
  public String toText() {
    return TextFormat.printer().printToString(toMessage());
  }

  /** What is usable of a message; the rest is counted. */
  static BallModels of(SSL_GeometryModels message, DecodingCounts counts) {
    Optional<FlatModel> flat = Optional.empty();
    Optional<ChipModel> chip = Optional.empty();
    if (message.hasStraightTwoPhase()) {
      try {
        flat = Optional.of(flat(message.getStraightTwoPhase()));
      } catch (IllegalArgumentException e) {
        counts.add(DecodingProblem.BAD_MODEL);
      }
    }
    if (message.hasChipFixedLoss()) {
      try {
        chip = Optional.of(chip(message.getChipFixedLoss(), flat));
      } catch (IllegalArgumentException e) {
        counts.add(DecodingProblem.BAD_MODEL);
      }
    }
    return new BallModels(flat, chip);
  }

  private static FlatModel flat(SSL_BallModelStraightTwoPhase message) {
    if (!message.isInitialized()) {
      throw new IllegalArgumentException(
          "straight_two_phase lacks " + message.findInitializationErrors());
    }
    return new FlatModel(message.getAccSlide(), message.getAccRoll(), message.getKSwitch());
  }

  private static ChipModel chip(SSL_BallModelChipFixedLoss message, Optional<FlatModel> flat) {
    if (!message.isInitialized()) {
      throw new IllegalArgumentException(
          "chip_fixed_loss lacks " + message.findInitializationErrors());
    }
    double accRoll = flat.map(FlatModel::accRoll).orElse(ChipModel.typical().accRoll());
    return new ChipModel(
        message.getDampingXyFirstHop(),
        message.getDampingXyOtherHops(),
        message.getDampingZ(),
        accRoll);
  }

  private static SSL_GeometryModels parse(byte[] content) {
    // The binary form starts with the tag of field 1 or 2, and no text does.
    boolean binary =
        content.length > 0 && (content[0] == 0x0a && isBinaryTail(content) || content[0] == 0x12);
    try {
      if (binary) {
        return SSL_GeometryModels.newBuilder().mergeFrom(content).buildPartial();
      }
      SSL_GeometryModels.Builder builder = SSL_GeometryModels.newBuilder();
      TextFormat.merge(new String(content, StandardCharsets.UTF_8), builder);
      return builder.buildPartial();
    } catch (InvalidProtocolBufferException | TextFormat.ParseException e) {
      throw new IllegalArgumentException(
          "is not SSL_GeometryModels, neither binary nor text: "
              + e.getMessage().replaceFirst("\\.$", ""),
          e);
    }
  }

  /** 0x0a is also a line feed; the straight model's length byte (3 doubles with tags = 27) is no text. */
  private static boolean isBinaryTail(byte[] content) {
    return content.length > 1
        && content[1] < ' '
        && content[1] != '\n'
        && content[1] != '\r'
        && content[1] != '\t';
  }
}
