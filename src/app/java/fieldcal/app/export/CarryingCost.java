package fieldcal.app.export;

import fieldcal.app.export.Target.TargetFile;
import fieldcal.app.wording.EffectName;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.KickerEffect;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.MotionEffect;
import fieldcal.kick.KickKind;
import fieldcal.vision.BallModels;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What of a model a target cannot carry, and by how much it then predicts wrong: each kick is followed with the extended model and with what the target has, and the places are
 * compared 0.5, 1 and 2 s after the kick.
 */
final class CarryingCost {
  private static final double[] AHEAD = {0.5, 1, 2};

  /** Nobody sees less on a field, mm. */
  private static final double VISIBLE_MM = 0.5;

  private final TargetFile file;
  private final ExportModel model;
  private final Map<String, Double> cut;
  private final ExtendedModel whole;
  private final List<ReferenceKick> kicks;
  private final boolean ownKicks;

  /**
   * Prepares the comparison.
   *
   * @param file of the target
   * @param model with at least one ball model
   * @param cut parameters that are out of the target's range, with what it makes of them, SI
   */
  CarryingCost(TargetFile file, ExportModel model, Map<String, Double> cut) {
    this.cut = cut;
    this.file = file;
    this.model = model;
    whole =
        model
            .extended()
            .orElseGet(
                () ->
                    new ExtendedModel(model.models().flat(), model.models().chip(), List.of(), 0));
    ownKicks = !model.kicks().isEmpty();
    List<ReferenceKick> all = ownKicks ? model.kicks() : ReferenceKick.usual(whole.sessionStart());
    BallModels plain = model.models();
    kicks =
        all.stream()
            .filter(
                k ->
                    k.kind() == KickKind.CHIP
                        ? whole.chip().isPresent() && plain.chip().isPresent()
                        : whole.flat().isPresent() && plain.flat().isPresent())
            .toList();
  }

  /** Distances of two predictions, mm: their root mean square and the largest, at each time. */
  private record Gap(double[] rms, double[] worst) {}

  /** What cannot be carried, most expensive first, then what all of it costs. */
  List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    List<Effect> lost = whole.effects().stream().filter(e -> !isCarried(e)).toList();
    List<Map.Entry<Double, String>> priced = new ArrayList<>();
    for (Effect effect : lost) {
      String name = EffectName.of(effect) + " (" + EffectName.strength(effect, Map.of()) + ")";
      if (file.carries().contains(effect.id())) {
        sentences.add(
            "The target has a key for "
                + EffectName.of(effect)
                + ": export extended_model.json itself to use it.");
      }
      if (effect instanceof KickerEffect) {
        sentences.add(
            "Not carried: " + name + ". It is about a kicker, not about the ball's path.");
      } else if (effect instanceof MotionEffect) {
        Gap gap = gap(whole, without(effect), kicks);
        priced.add(
            Map.entry(
                gap.rms()[1], "Not carried: " + name + ". That alone costs " + words(gap) + "."));
      } else if (effect instanceof MeasurementEffect) {
        sentences.add(
            "Not carried: "
                + name
                + ". It is an error of the cameras, not of the ball: correct it there.");
      }
    }
    if (!priced.isEmpty() && !model.beside()) {
      sentences.add(
          "These parameters are valid only together with what is not carried. A program that reads"
              + " them alone predicts better with the parameters of calibrate without --model.");
    }
    priced.sort(Map.Entry.<Double, String>comparingByKey().reversed());
    List<String> all =
        priced.stream().map(Map.Entry::getValue).collect(Collectors.toCollection(ArrayList::new));
    all.addAll(sentences);
    file.instead()
        .forEach(
            (lacks, uses) ->
                all.add(
                    "The target has no "
                        + QuantityWords.of(lacks)
                        + " and uses the "
                        + QuantityWords.of(uses)
                        + "."));
    total().ifPresent(all::add);
    return all;
  }

  /** Parameters that were calibrated without an effect are wrong together with it. */
  private boolean isCarried(Effect effect) {
    return !model.beside() && file.carries().contains(effect.id());
  }

  private Optional<String> total() {
    List<ReferenceKick> known = kicks.stream().filter(k -> isKnown(k.kind())).toList();
    String unknown =
        known.size() == kicks.size()
            ? ""
            : "How far its chips are off is not known: it has horizontal dampings of its own.";
    if (known.isEmpty()) {
      return Optional.of(unknown).filter(s -> !s.isEmpty());
    }
    return Optional.of(unknown.isEmpty() ? total(known) : total(known) + " " + unknown);
  }

  /** Whether all parameters of the target's kicks of a kind are known. */
  private boolean isKnown(KickKind kind) {
    return kind == KickKind.FLAT || file.unknown().isEmpty();
  }

  private String total(List<ReferenceKick> compared) {
    Gap gap = gap(whole, target(), compared);
    boolean seen = gap.rms()[2] >= VISIBLE_MM;
    String reference = whole.effects().isEmpty() ? "the calibrated model" : "the whole model";
    String over =
        ownKicks
            ? (compared.size() == 1
                    ? "over the kick of "
                    : "over the " + compared.size() + " kicks of ")
                + model.file().getFileName()
            : "over "
                + compared.size()
                + " kicks of 2 to 6.5 m/s from the centre in all directions";
    return seen
        ? "In all, the target's prediction is off from that of "
            + reference
            + " by "
            + words(gap)
            + ", "
            + over
            + "."
            + compensation()
        : "The target repeats "
            + reference
            + " to within "
            + VISIBLE_MM
            + " mm after 2 s, "
            + over
            + ".";
  }

  /** Why the whole is less than a part of it, and than what a diagnosis says of the calibrated model. */
  private String compensation() {
    return model.beside() && !whole.effects().isEmpty()
        ? " The calibrated parameters make up for a part of what is not carried. Both predictions"
            + " begin with the same kick; how far they are off for an AI, which sees only the first"
            + " 0.3 s of it, is in the table of diagnose."
        : "";
  }

  private static String words(Gap gap) {
    return String.format(
        Locale.ROOT,
        "%s mm after 0.5 s, %s mm after 1 s and %s mm after 2 s (root mean square; at most %s mm)",
        mm(gap.rms()[0]),
        mm(gap.rms()[1]),
        mm(gap.rms()[2]),
        mm(Arrays.stream(gap.worst()).max().orElseThrow()));
  }

  private static String mm(double value) {
    return String.format(Locale.ROOT, value < 9.95 ? "%.1f" : "%.0f", value);
  }

  private ExtendedModel without(Effect effect) {
    return new ExtendedModel(
        whole.flat(),
        whole.chip(),
        whole.effects().stream().filter(e -> e != effect).toList(),
        whole.sessionStart());
  }

  /** What the target has once the file is in use. */
  private ExtendedModel target() {
    List<Effect> carried = whole.effects().stream().filter(this::isCarried).toList();
    Optional<FlatModel> flat =
        model
            .models()
            .flat()
            .map(
                m ->
                    new FlatModel(
                        parameter("acc_slide"), parameter("acc_roll"), parameter("k_switch")));
    Optional<ChipModel> chip =
        model
            .models()
            .chip()
            .map(
                m ->
                    new ChipModel(
                        parameter("damping_xy_first_hop"),
                        parameter("damping_xy_other_hops"),
                        parameter("damping_z"),
                        m.accRoll()));
    return new ExtendedModel(flat, chip, carried, whole.sessionStart());
  }

  private double parameter(String name) {
    String used = file.instead().getOrDefault(name, name);
    Double fixed = file.fixed().getOrDefault(name, cut.get(used));
    return fixed != null ? fixed : model.quantities().of(used).orElseThrow();
  }

  private static Gap gap(ExtendedModel a, ExtendedModel b, List<ReferenceKick> kicks) {
    double[] squares = new double[AHEAD.length];
    double[] worst = new double[AHEAD.length];
    double[] p = new double[3];
    double[] q = new double[3];
    for (ReferenceKick kick : kicks) {
      ExtendedTrajectory one = path(a, kick);
      ExtendedTrajectory other = path(b, kick);
      for (int i = 0; i < AHEAD.length; i++) {
        one.positionAt(kick.time() + AHEAD[i], p);
        other.positionAt(kick.time() + AHEAD[i], q);
        double mm = 1000 * Math.hypot(p[0] - q[0], p[1] - q[1]);
        squares[i] += mm * mm;
        worst[i] = Math.max(worst[i], mm);
      }
    }
    for (int i = 0; i < squares.length; i++) {
      squares[i] = kicks.isEmpty() ? 0 : Math.sqrt(squares[i] / kicks.size());
    }
    return new Gap(squares, worst);
  }

  private static ExtendedTrajectory path(ExtendedModel model, ReferenceKick k) {
    return k.kind() == KickKind.CHIP
        ? model.chipPath(k.time(), k.x(), k.y(), k.vx(), k.vy(), k.vz())
        : model.flatPath(k.time(), k.x(), k.y(), k.vx(), k.vy());
  }
}
