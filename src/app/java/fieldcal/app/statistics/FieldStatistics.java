package fieldcal.app.statistics;

import fieldcal.app.statistics.Statistic.How;
import fieldcal.app.wording.ParameterWords;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;

/** All statistics of the recordings of one field. */
public final class FieldStatistics {
  private static final double GRAVITY = 9.81;
  private static final double MM = 1000;

  /** Distances from the point below a camera that divide its noise, m: a third and two thirds of what a camera of a quarter field sees. */
  private static final double[] PLACES = {0, 2, 4, Double.POSITIVE_INFINITY};

  private final FieldRecording field;
  private final Function<Kick, Optional<String>> names;
  private final Map<String, Statistic> all = new TreeMap<>();
  private final List<String> order = new ArrayList<>();

  private FieldStatistics(FieldRecording field, Function<Kick, Optional<String>> names) {
    this.field = field;
    this.names = names;
  }

  /**
   * All statistics.
   *
   * @param field its recordings
   * @param names of kicks, the same for the same kick of two recordings; empty for one that is not to count
   * @return cameras first, then the ball
   */
  public static List<Statistic> of(FieldRecording field, Function<Kick, Optional<String>> names) {
    return of(field, names, field.calibration().calibration().fitted());
  }

  /**
   * All statistics, from other fits.
   *
   * @param field its recordings
   * @param names of kicks, the same for the same kick of two recordings; empty for one that is not to count
   * @param fits of its kicks
   * @return cameras first, then the ball
   */
  public static List<Statistic> of(
      FieldRecording field, Function<Kick, Optional<String>> names, List<KickFit> fits) {
    FieldStatistics made = new FieldStatistics(field, names);
    for (int i = 0; i < field.frames().size(); i++) {
      made.frames(i);
    }
    fits.forEach(made::fit);
    return made.order.stream().map(made.all::get).toList();
  }

  private void add(String id, String words, String unit, How how, String key, double value) {
    Statistic before = all.get(id);
    Map<String, Double> samples =
        before == null ? new TreeMap<>() : new TreeMap<>(before.samples());
    if (before == null) {
      order.add(id);
    }
    samples.put(key, value);
    all.put(id, new Statistic(id, words, unit, how, samples));
  }

  private void frames(int index) {
    RecordedFrames one = field.frames().get(index);
    List<Kick> kicks = field.kicks(one).stream().filter(k -> names.apply(k).isPresent()).toList();
    Map<Integer, String> names = new TreeMap<>();
    kicks.forEach(k -> names.put(k.id(), this.names.apply(k).orElseThrow()));
    for (RestStretches.Stretch s : RestStretches.of(one, kicks)) {
      String key = names.get(s.kick());
      int place = place(s);
      add(
          "noise." + s.camera() + "." + place,
          "noise of camera " + s.camera() + placeWords(place),
          "mm",
          How.PAIRED,
          key,
          MM * s.sigma());
      add(
          "missed_balls." + s.camera(),
          "resting balls that camera " + s.camera() + " misses",
          "%",
          How.LEVEL,
          key,
          100.0 * (s.frames() - s.detections()) / s.frames());
    }
    for (FrameBlocks.Block b : FrameBlocks.of(one)) {
      String key = index + "/" + b.number();
      String of = " of camera " + b.camera();
      add(
          "interval." + b.camera(),
          "time between frames" + of,
          "ms",
          How.LEVEL,
          key,
          MM * b.interval());
      add(
          "interval_scatter." + b.camera(),
          "scatter of the time between frames" + of,
          "ms",
          How.LEVEL,
          key,
          MM * b.scatter());
      add("lost." + b.camera(), "lost frames" + of, "%", How.LEVEL, key, 100 * b.lost());
      add("delay." + b.camera(), "delay" + of, "ms", How.LEVEL, key, MM * b.delay());
    }
    for (Kick kick : kicks) {
      add(
          "false_balls",
          "false balls per 1000 frames",
          "",
          How.LEVEL,
          names.get(kick.id()),
          1000 * FrameBlocks.falseBalls(one, kick));
    }
  }

  private int place(RestStretches.Stretch s) {
    double distance =
        field.calibration().calibration().cameras().all().stream()
            .filter(view -> view.id() == s.camera())
            .flatMap(view -> view.camera().stream())
            .mapToDouble(c -> Math.hypot(s.x() - c.positionX(), s.y() - c.positionY()))
            .findFirst()
            .orElse(0);
    int place = 0;
    while (distance >= PLACES[place + 1]) {
      place++;
    }
    return place;
  }

  private static String placeWords(int place) {
    return place + 2 == PLACES.length
        ? String.format(Locale.ROOT, " beyond %.0f m", PLACES[place])
        : String.format(
            Locale.ROOT, " %.0f to %.0f m from below it", PLACES[place], PLACES[place + 1]);
  }

  private void fit(KickFit fit) {
    Optional<String> name = names.apply(fit.kick());
    if (name.isEmpty()) {
      return;
    }
    String key = name.get();
    for (ResidualSpectrum.Band band : ResidualSpectrum.of(fit)) {
      add(
          "residual." + band.camera() + "." + band.name(),
          String.format(Locale.ROOT, "residual of camera %d at %s", band.camera(), band.words()),
          "mm",
          How.PAIRED,
          key,
          MM * band.amplitude());
    }
    parameters(fit, key);
    MeasuredMotion motion = MeasuredMotion.of(fit, field.calibration().calibration().cameras());
    motion
        .rolled()
        .ifPresent(d -> add("rolled", "distance to where the ball stops", "m", How.PAIRED, key, d));
    motion
        .speedAfter(1)
        .ifPresent(v -> add("speed_after_1s", "speed after 1 s", "m/s", How.PAIRED, key, v));
    if (fit.kind() == KickKind.FLAT) {
      motion
          .braking()
          .forEach(
              (range, a) ->
                  add(
                      "braking." + range.id(),
                      "deceleration of a rolling ball at " + range.words(),
                      "m/s²",
                      How.PAIRED,
                      key,
                      a));
    }
  }

  private static String kinds(KickKind kind) {
    return kind == KickKind.CHIP ? "chips" : "flat kicks";
  }

  private void parameters(KickFit fit, String key) {
    String kind = fit.kind().id();
    for (Estimate e : fit.modelEstimates()) {
      if (e.usable()) {
        String what = ParameterWords.words(e.name()) + " of " + kinds(fit.kind());
        add(kind + "." + e.name(), what, e.parameter().unit(), How.PAIRED, key, e.value());
        add(
            kind + "_scatter." + e.name(),
            "scatter of " + what,
            e.parameter().unit(),
            How.SCATTER,
            key,
            e.value());
      }
    }
    if (fit.kind() == KickKind.CHIP) {
      double vz = fit.estimate("vz").value();
      double second = vz * fit.estimate("dampingZ").value();
      add("hop.1", "height of the first hop", "m", How.PAIRED, key, vz * vz / 2 / GRAVITY);
      add("hop.2", "height of the second hop", "m", How.PAIRED, key, second * second / 2 / GRAVITY);
    }
  }
}
