package fieldcal.vision;

/** A kind of damage or oddity in received data, counted instead of thrown. */
public interface ProblemKind {
  /**
   * The name of the kind as written in files.
   *
   * @return lower-case words joined by underscores
   */
  String id();

  /**
   * What happened and what became of the data, for people.
   *
   * @return one phrase, without a final full stop
   */
  String text();
}
