package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.KickTermContract;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Kicks under the closed forms, whose derivatives are exact. */
class FlightTermTest extends KickTermContract<double[]> {
  /** Exact but for the phase that a detection at its border belongs to. */
  private static final double TOLERANCE = 1e-3;

  private static final int[] NOTHING_SCATTERS = {};

  private static final long UNEVEN_SEED = 4;

  private static List<Parameter> globals() {
    List<Parameter> all = new ArrayList<>();
    all.addAll(new FlatModel(-3.1, -0.28, 0.63).parameters());
    all.addAll(new ChipModel(0.72, 0.91, 0.5, -0.27).parameters());
    for (int camera = 0; camera < 2; camera++) {
      for (String axis : new String[] {"x", "y"}) {
        all.add(new Parameter(axis + camera, "m", 0.002, 0.01, -1, 1, true, "test"));
      }
    }
    return all;
  }

  private static FlightTerm term(KickKind kind, long seed, int[] scattering) {
    SplittableRandom random = new SplittableRandom(seed);
    IdealKicks source = new IdealKicks(FitSupport.CLEAN.noise());
    IdealKicks.Sample s = source.draw(kind, 1, FitSupport.CLEAN, random);
    KickFit fit = FitSupport.fit(FitSupport.problem(s, source.views(), random), kind);
    FlightData data = FlightData.of(s.kick().observations(), source.views());
    return FlightTerm.of(fit, data, data.camera.clone(), globals(), scattering);
  }

  /** A chip with four bounces after the first, which may differ from each other. */
  private static FlightTerm uneven(int[] scattering) {
    IdealKicks source = new IdealKicks(FitSupport.CLEAN.noise());
    SplittableRandom random = new SplittableRandom(UNEVEN_SEED);
    double[] truth = {0.1, -4, 0.5, 3.4, 3.8, 0.5, 0.72, 0.91, 0.55, -0.27};
    IdealKicks.Sample s = source.observe(KickKind.CHIP, truth, 1, FitSupport.CLEAN, random);
    KickFit fit =
        FitSupport.fit(FitSupport.problem(s, source.views(), random), KickKind.CHIP)
            .withUnevenBounces(source.views(), 0.03);
    FlightData data = FlightData.of(s.kick().observations(), source.views());
    return FlightTerm.of(fit, data, data.camera.clone(), globals(), scattering);
  }

  @Override
  protected List<Case<double[]>> cases() {
    List<Case<double[]>> cases = new ArrayList<>();
    for (KickKind kind : KickKind.values()) {
      for (long seed = 1; seed <= 3; seed++) {
        for (int[] scattering : new int[][] {NOTHING_SCATTERS, {0, 2, 3, 5}}) {
          FlightTerm term = term(kind, seed, scattering);
          String name = kind + ", seed " + seed + ", " + scattering.length + " scatter";
          cases.add(
              new Case<>(
                  name,
                  term,
                  term.start(),
                  scales(kind, 0, scattering),
                  double[]::clone,
                  globals(),
                  TOLERANCE));
        }
      }
    }
    for (int[] scattering : new int[][] {NOTHING_SCATTERS, {3, 4}}) {
      FlightTerm term = uneven(scattering);
      int bounces = term.ownSize() - FlightLayout.kickSize(KickKind.CHIP) - scattering.length;
      assertThat(bounces).isPositive();
      cases.add(
          new Case<>(
              "uneven bounces, " + scattering.length + " scatter",
              term,
              term.start(),
              scales(KickKind.CHIP, bounces, scattering),
              double[]::clone,
              globals(),
              TOLERANCE));
    }
    return cases;
  }

  /** 1 cm, 0.1 m/s and 5 ms, then those of the bounces and of what differs from kick to kick. */
  private static double[] scales(KickKind kind, int bounces, int[] scattering) {
    int time = FlightLayout.timeIndex(kind);
    double[] scales = new double[time + 1 + bounces + scattering.length];
    Arrays.fill(scales, 0, 2, 0.01);
    Arrays.fill(scales, 2, time, 0.1);
    scales[time] = 0.005;
    Arrays.fill(scales, time + 1, time + 1 + bounces, 0.1);
    for (int r = 0; r < scattering.length; r++) {
      scales[time + 1 + bounces + r] = globals().get(scattering[r]).scale();
    }
    return scales;
  }

  @Test
  void aChipHasOneFlightMoreOrLess() {
    FlightTerm chip = term(KickKind.CHIP, 1, new int[] {3, 4, 5});
    double[] state = globals().stream().mapToDouble(Parameter::value).toArray();
    assertThat(chip.neighbours()).hasSize(2);
    assertThat(chip.penalty(chip.start(), state)).isZero();
    KickTerm<double[]> far = chip;
    for (int i = 0; i < 4; i++) {
      far = far.neighbours().get(1);
    }
    assertThat(far.penalty(chip.start(), state)).isInfinite();
    assertThat(term(KickKind.FLAT, 1, NOTHING_SCATTERS).neighbours()).isEmpty();
  }

  @Test
  void theKicksOwnValuesStandForTheModels() {
    FlightTerm alike = term(KickKind.FLAT, 2, NOTHING_SCATTERS);
    FlightTerm scattered = term(KickKind.FLAT, 2, new int[] {0, 3});
    assertThat(scattered.ownSize()).isEqualTo(alike.ownSize() + 2);
    double[] state = globals().stream().mapToDouble(Parameter::value).toArray();
    double[] own = scattered.start();
    double[] out = new double[scattered.rows()];
    double[] same = new double[scattered.rows()];
    scattered.residuals(own, state, out);
    state[0] -= 1;
    scattered.residuals(own, state, same);
    assertThat(same).isEqualTo(out);
    // A parameter of chips changes no flat kick.
    own[own.length - 1] += 0.1;
    scattered.residuals(own, state, same);
    assertThat(same).isEqualTo(out);
  }
}
