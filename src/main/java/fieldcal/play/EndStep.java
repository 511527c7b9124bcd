package fieldcal.play;

/** The play is over. */
record EndStep(PlayPhase phase, String reason) implements Step {
  @Override
  public Step tick(Situation s) {
    return this;
  }
}
