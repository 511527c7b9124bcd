package fieldcal.gamelog;

import fieldcal.vision.VisionFrame;
import java.util.List;

/**
 * By how much the frame numbers of one camera rise from frame to frame: 1, or more where the number counts the frames of all cameras. The most frequent step is that of an unbroken sequence; larger steps are its multiples.
 *
 * @param usual the most frequent step, 1 or more
 */
public record FrameStep(int usual) {
  /** Largest step that is distinguished: four times the largest number of cameras of a field. */
  static final int MAX = 32;

  /**
   * Checks the step. {@inheritDoc}
   *
   * @throws IllegalArgumentException when it is not positive
   */
  public FrameStep {
    if (usual < 1) {
      throw new IllegalArgumentException("usual: must be 1 or more, but is " + usual);
    }
  }

  /**
   * The step of a camera's frames.
   *
   * @param frames of one camera, in order of their capture
   * @return 1 when there are fewer than two frames
   */
  public static FrameStep of(List<VisionFrame> frames) {
    long[] counts = new long[MAX + 1];
    for (int i = 1; i < frames.size(); i++) {
      long step = frames.get(i).frameNumber() - frames.get(i - 1).frameNumber();
      if (step >= 1) {
        counts[(int) Math.min(step, MAX)]++;
      }
    }
    return of(counts);
  }

  /** From how often each step from 0 to {@link #MAX} occurred; the last entry also counts larger ones. */
  static FrameStep of(long[] counts) {
    int usual = 1;
    for (int step = 2; step < counts.length; step++) {
      if (counts[step] > counts[usual]) {
        usual = step;
      }
    }
    return new FrameStep(usual);
  }

  /**
   * How many frames are missing between two.
   *
   * @param before number of the earlier frame
   * @param after number of the later frame
   * @return 0 when the later one follows at once, and when the numbers do not rise
   */
  public long missing(long before, long after) {
    return Math.max(0, Math.round((after - before) / (double) usual) - 1);
  }
}
