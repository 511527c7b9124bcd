package fieldcal.app.monitor;

import fieldcal.gamelog.RefereeState;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.util.concurrent.Executor;

/** Where frames and the referee's messages come from. Used once. */
public interface MatchFeed extends AutoCloseable {

  /** Is told what happens, and asked whether to go on. */
  interface Control {
    /**
     * The referee says something; comes over and over.
     *
     * @param state what it says
     */
    void referee(RefereeState state);

    /** The referee has been silent for so long that what it said last is no longer true. */
    void refereeLost();

    /**
     * Called several times a second.
     *
     * @return false when the feed shall end
     */
    boolean goOn();
  }

  /**
   * The instant that the frames' times count from.
   *
   * @return the epoch
   */
  Epoch epoch();

  /**
   * What takes long, done as this feed needs it: beside the frames when they come as they come, between them when they can wait.
   *
   * @return runs the monitor's tasks
   */
  Executor executor();

  /**
   * Settings that suit the feed.
   *
   * @param settings the usual ones
   * @return the usual ones or changed ones
   */
  LiveSettings suited(LiveSettings settings);

  /**
   * Feeds until there is no more or it shall end.
   *
   * @param monitor is given geometry and frames
   * @param control is told the rest
   * @throws IOException when nothing more can be read; one line for the operator
   */
  void run(LiveMonitor monitor, Control control) throws IOException;

  /**
   * One line on where frames come from and how far it is.
   *
   * @return for the operator
   */
  FeedStatus status();

  @Override
  void close() throws IOException;
}
