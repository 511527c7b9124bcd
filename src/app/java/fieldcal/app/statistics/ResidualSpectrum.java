package fieldcal.app.statistics;

import fieldcal.fit.KickFit;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * How slow or fast the residuals of a kick change: their periodogram, averaged over bands, per camera. White noise has the same amplitude in all bands; a wrong model shows in the slow ones.
 */
final class ResidualSpectrum {
  /** Edges of the bands, Hz: a flight of some seconds, its hops, the frames. */
  private static final double[] EDGES = {0.5, 2, 6, 20};

  private static final int FREQUENCIES = 6;

  /** Fewest detections of one camera. */
  private static final int FEWEST = 30;

  private ResidualSpectrum() {}

  /**
   * One camera's residuals of one kick in one band.
   *
   * @param camera the camera
   * @param from lower edge, Hz
   * @param to upper edge, Hz
   * @param amplitude root of the mean power per axis; of white noise its standard deviation, m
   */
  record Band(int camera, double from, double to, double amplitude) {
    String name() {
      return String.format(Locale.ROOT, "%gHz", from);
    }

    String words() {
      return String.format(
          Locale.ROOT,
          "%s to %.0f Hz",
          from < 1 ? "0.5" : String.format(Locale.ROOT, "%.0f", from),
          to);
    }
  }

  static List<Band> of(KickFit fit) {
    List<Band> bands = new ArrayList<>();
    Observations seen = fit.kick().observations();
    for (int camera : seen.cameras()) {
      int n = 0;
      double[] t = new double[seen.size()];
      double[] x = new double[seen.size()];
      double[] y = new double[seen.size()];
      for (int i = 0; i < seen.size(); i++) {
        if (seen.camera(i) == camera && fit.used(i)) {
          t[n] = seen.time(i) - fit.kick().time();
          x[n] = fit.residualX(i);
          y[n++] = fit.residualY(i);
        }
      }
      for (int b = 0; n >= FEWEST && b + 1 < EDGES.length; b++) {
        bands.add(new Band(camera, EDGES[b], EDGES[b + 1], amplitude(t, x, y, n, b)));
      }
    }
    return bands;
  }

  private static double amplitude(double[] t, double[] x, double[] y, int n, int band) {
    double sum = 0;
    for (int f = 0; f < FREQUENCIES; f++) {
      double share = (f + 0.5) / FREQUENCIES;
      double omega = 2 * Math.PI * (EDGES[band] + share * (EDGES[band + 1] - EDGES[band]));
      double cosX = 0;
      double sinX = 0;
      double cosY = 0;
      double sinY = 0;
      for (int i = 0; i < n; i++) {
        double c = Math.cos(omega * t[i]);
        double s = Math.sin(omega * t[i]);
        cosX += c * x[i];
        sinX += s * x[i];
        cosY += c * y[i];
        sinY += s * y[i];
      }
      sum += (cosX * cosX + sinX * sinX + cosY * cosY + sinY * sinY) / (2 * n);
    }
    return Math.sqrt(sum / FREQUENCIES);
  }
}
