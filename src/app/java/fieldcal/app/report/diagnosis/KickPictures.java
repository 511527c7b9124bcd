package fieldcal.app.report.diagnosis;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.Locale;
import java.util.stream.IntStream;

/** Turns the kicks of a diagnosis into what the report shows of them, thinned so that a page of any number of kicks opens quickly. */
final class KickPictures {
  /** Observations on the whole page: about 40 bytes each. */
  private static final int ALL_OBSERVATIONS = 14_000;

  /** More of one kick cannot be seen in a picture. */
  private static final int MOST_OF_A_KICK = 500;

  private static final int FEWEST_OF_A_KICK = 40;
  private static final int PATH_POINTS = 40;

  /** Slower balls have no direction worth speaking of, m/s. */
  private static final double STANDSTILL = 1e-3;

  private final CollectedKicks data;
  private final int perKick;

  KickPictures(CollectedKicks data, int kicks) {
    this.data = data;
    perKick =
        Math.max(FEWEST_OF_A_KICK, Math.min(MOST_OF_A_KICK, ALL_OBSERVATIONS / Math.max(1, kicks)));
  }

  KickPicture of(KickResiduals k) {
    Kick kick = k.kick();
    BallState start = k.after().stateAt(k.after().kickTime());
    int unused = (int) IntStream.range(0, k.used().length).filter(i -> !k.used()[i]).count();
    return new KickPicture(
        kick.id(),
        k.kind().id(),
        data.sources().getOrDefault(kick.id(), ""),
        data.epoch().unixSeconds(kick.time()),
        kick.robot()
            .map(r -> r.team().name().toLowerCase(Locale.ROOT) + " " + r.number())
            .orElse(""),
        Math.hypot(start.groundSpeed(), start.vz()),
        Math.toDegrees(Math.atan2(start.vy(), start.vx())),
        kick.observations().size(),
        unused,
        k.rmsBeforeMm(),
        k.rmsAfterMm(),
        path(k.before(), kick.endTime()),
        path(k.after(), kick.endTime()),
        seen(k));
  }

  private static KickPicture.Path path(BallTrajectory path, double until) {
    double t0 = path.kickTime();
    double end = Math.max(t0, Math.min(until, path.restTime()));
    double[][] columns = new double[4][PATH_POINTS + 1];
    for (int i = 0; i <= PATH_POINTS; i++) {
      // The ball is fastest at the begin, where its path wants more points.
      double share = (double) i / PATH_POINTS;
      double t = t0 + (end - t0) * share * share;
      BallState s = path.stateAt(t);
      boolean moves = s.groundSpeed() > STANDSTILL;
      columns[0][i] = t - t0;
      columns[1][i] = s.x();
      columns[2][i] = s.y();
      double last = columns[3][Math.max(0, i - 1)];
      // Without steps of a full turn, so that the page may interpolate.
      columns[3][i] =
          moves ? last + Math.IEEEremainder(Math.atan2(s.vy(), s.vx()) - last, 2 * Math.PI) : last;
    }
    return new KickPicture.Path(columns[0], columns[1], columns[2], columns[3]);
  }

  private KickPicture.Seen seen(KickResiduals k) {
    Observations o = k.kick().observations();
    int[] index = thinned(k);
    double[] heading = new double[index.length];
    double last = Math.atan2(k.kick().vy(), k.kick().vx());
    for (int n = 0; n < index.length; n++) {
      BallState s = k.after().stateAt(o.time(index[n]));
      last = s.groundSpeed() > STANDSTILL ? Math.atan2(s.vy(), s.vx()) : last;
      heading[n] = last;
    }
    return new KickPicture.Seen(
        IntStream.of(index).mapToDouble(i -> o.time(i) - k.after().kickTime()).toArray(),
        IntStream.of(index).map(o::camera).toArray(),
        turned(index, k.xBefore(), k.yBefore(), heading, 0),
        turned(index, k.xBefore(), k.yBefore(), heading, Math.PI / 2),
        turned(index, k.xAfter(), k.yAfter(), heading, 0),
        turned(index, k.xAfter(), k.yAfter(), heading, Math.PI / 2));
  }

  /** Residuals in a direction relative to the heading, mm. */
  private static double[] turned(
      int[] index, double[] x, double[] y, double[] heading, double angle) {
    return IntStream.range(0, index.length)
        .mapToDouble(
            n ->
                1000
                    * (x[index[n]] * Math.cos(heading[n] + angle)
                        + y[index[n]] * Math.sin(heading[n] + angle)))
        .toArray();
  }

  /** The same share of each camera's used observations since the kick: every other one of all could be all of one camera. */
  private int[] thinned(KickResiduals k) {
    Observations o = k.kick().observations();
    int[] all =
        IntStream.range(0, o.size())
            .filter(i -> k.used()[i] && o.time(i) >= k.after().kickTime())
            .toArray();
    int step = (all.length + perKick - 1) / perKick;
    return IntStream.of(o.cameras())
        .flatMap(
            camera -> {
              int[] its = IntStream.of(all).filter(i -> o.camera(i) == camera).toArray();
              return IntStream.range(0, its.length).filter(n -> n % step == 0).map(n -> its[n]);
            })
        .sorted()
        .toArray();
  }
}
