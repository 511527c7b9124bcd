package fieldcal.simulation.imaging;

/** Rounds lengths as the wire does, so that a recording in memory and one read from a file are the same. */
final class Millimetres {

  private Millimetres() {}

  /** Metres to 32-bit millimetres and back. */
  static double rounded(double metres) {
    return (float) (metres * 1000) / 1000.0;
  }
}
