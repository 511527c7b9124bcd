package fieldcal.app.monitor;

import fieldcal.app.net.MatchNetwork;
import fieldcal.app.net.NetworkPlace;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;

/** A running match, received from the network; kicks are fitted on a thread of low priority. */
public final class NetworkFeed implements MatchFeed {
  /** How long to wait for a packet before the control is asked again, ms. */
  private static final long WAIT = 50;

  /** A referee that said nothing for so long is gone: what it said last may no longer be true, ns. */
  private static final long REFEREE_GONE = 10_000_000_000L;

  /** Vision sends 70 times a second; after so long it is worth a line, s. */
  private static final double SILENT = 3;

  private static final long LAST_WORK = 3;

  private final NetworkPlace vision;
  private final Optional<NetworkPlace> referee;
  private final Epoch epoch;
  private final MatchNetwork network;
  private final ExecutorService worker;
  private LiveMonitor monitor;
  private Control control;
  private long refereeAt;
  private boolean hasReferee;

  /**
   * Begins to receive.
   *
   * @param vision where vision sends to
   * @param referee where the referee sends to, if it shall be listened to
   * @throws IOException when a port cannot be opened; one line for the operator
   */
  public NetworkFeed(NetworkPlace vision, Optional<NetworkPlace> referee) throws IOException {
    this.vision = vision;
    this.referee = referee;
    epoch = Epoch.atSecondOf(System.currentTimeMillis() / 1000.0);
    network = new MatchNetwork(vision, referee, epoch, new ToMonitor());
    worker = Executors.newSingleThreadExecutor(NetworkFeed::thread);
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "fieldcal-fits");
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
    return thread;
  }

  @Override
  public Epoch epoch() {
    return epoch;
  }

  @Override
  public Executor executor() {
    return worker;
  }

  @Override
  public LiveSettings suited(LiveSettings settings) {
    return settings;
  }

  @Override
  public void run(LiveMonitor to, Control asked) throws IOException {
    monitor = to;
    control = asked;
    try {
      while (control.goOn()) {
        // Whatever has come, before anybody is asked anything; but not for ever.
        for (int i = 0; i < 100 && network.receive(i == 0 ? WAIT : 0) > 0; i++) {
          // Each call gives the sink one packet of vision.
        }
        if (hasReferee && System.nanoTime() - refereeAt > REFEREE_GONE) {
          hasReferee = false;
          control.refereeLost();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public FeedStatus status() {
    String title = vision + referee.map(r -> ", referee " + r).orElse("");
    return new FeedStatus(title, network.notes(), network.withoutFrames() > SILENT);
  }

  @Override
  public void close() {
    network.close();
    worker.shutdown();
    try {
      worker.awaitTermination(LAST_WORK, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Passes on what comes. */
  private final class ToMonitor implements MatchNetwork.Sink {
    @Override
    public void frame(VisionFrame frame) {
      monitor.accept(frame);
    }

    @Override
    public void geometry(FieldGeometry geometry) {
      monitor.geometry(geometry);
    }

    @Override
    public void referee(RefereeState state) {
      hasReferee = true;
      refereeAt = System.nanoTime();
      control.referee(state);
    }
  }
}
