package fieldcal.app.console;

import fieldcal.app.diagnose.DiagnosisSession;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Long work, one at a time, with progress, and ended when nobody wants it any more. What the operator asked for is not started twice; what the console does on its own waits for that.
 * Thread-safe.
 */
final class Work {
  /** Progress is told that often, ms; more nobody can read. */
  private static final long TELL_MS = 150;

  /** What is to be done. */
  interface Task {
    /** Does it, and tells its errors itself; a cancelled task ends at its next word about the progress. */
    void run(Progress progress);
  }

  /** Told when anything about the work changed. */
  interface Listener {
    void changed();
  }

  /**
   * How far a task is, for a page.
   *
   * @param title what is done
   * @param text more about it, for example a file's name; may be empty
   * @param done so many
   * @param total of so many; 0 when nobody knows
   * @param asked whether the operator asked for it, and may cancel it
   */
  record Status(String title, String text, double done, double total, boolean asked) {}

  private record Job(Task task, Progress progress) {}

  private static final Logger LOG = LoggerFactory.getLogger(Work.class);

  private final Listener listener;
  private final Deque<Job> waiting = new ArrayDeque<>();
  private final Thread thread;
  private Job current;
  private boolean closed;

  Work(Listener listener) {
    this.listener = listener;
    thread = new Thread(this::runAll, "work");
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /**
   * Does what the operator asked for.
   *
   * @throws ApiException when something that was asked for before is not done yet
   */
  synchronized void ask(String title, Task task) {
    asked()
        .ifPresent(
            busy -> {
              throw ApiException.conflict(
                  "busy with “" + busy.title + "”: wait until it ends, or cancel it");
            });
    put(new Job(task, new Progress(title, true)));
  }

  /** Does something on the console's own account; what it did not finish before of the same title is given up. */
  synchronized void again(String title, Task task) {
    waiting.removeIf(job -> job.progress.isOwn(title));
    if (current != null && current.progress.isOwn(title)) {
      current.progress.cancel();
    }
    put(new Job(task, new Progress(title, false)));
  }

  private void put(Job job) {
    if (!closed) {
      waiting.add(job);
      notifyAll();
    }
  }

  private Optional<Progress> asked() {
    if (current != null && current.progress.asked && !current.progress.cancelled) {
      return Optional.of(current.progress);
    }
    return waiting.stream().map(Job::progress).filter(p -> p.asked).findFirst();
  }

  /** Ends what the operator asked for, at its next word about the progress. */
  void cancel() {
    synchronized (this) {
      waiting.removeIf(job -> job.progress.asked);
      if (current != null && current.progress.asked) {
        current.progress.cancel();
      }
    }
    listener.changed();
  }

  /** What is being done, or is about to be. */
  synchronized Optional<Status> status() {
    Job job = current == null ? waiting.peek() : current;
    return job == null ? Optional.empty() : Optional.of(job.progress.status());
  }

  void close() {
    synchronized (this) {
      closed = true;
      waiting.clear();
      if (current != null) {
        current.progress.cancel();
      }
      notifyAll();
    }
    thread.interrupt();
  }

  private void runAll() {
    try {
      while (true) {
        Job job;
        synchronized (this) {
          current = null;
          while (waiting.isEmpty() && !closed) {
            wait();
          }
          if (closed) {
            return;
          }
          job = waiting.poll();
          current = job;
        }
        guarded(job, listener::changed);
        guarded(job, () -> job.task.run(job.progress));
        synchronized (this) {
          current = null;
        }
        guarded(job, listener::changed);
      }
    } catch (InterruptedException e) {
      // Closed.
    }
  }

  private static void guarded(Job job, Runnable step) {
    try {
      step.run();
    } catch (CancellationException e) {
      // Wanted.
    } catch (RuntimeException | Error e) {
      // A task tells its errors itself; whatever it or the listener lets out must not end the
      // thread that the next one needs.
      LOG.error("defect in “{}”", job.progress.title, e);
    }
  }

  /** How far a task is; every word about it is also where a cancelled task ends. */
  final class Progress implements DiagnosisSession.Progress {
    private final String title;
    private final boolean asked;
    private volatile boolean cancelled;
    private String text = "";
    private double done;
    private double total;
    private long told;
    private List<Path> logs = List.of();

    Progress(String title, boolean asked) {
      this.title = title;
      this.asked = asked;
    }

    boolean isOwn(String other) {
      return !asked && title.equals(other);
    }

    void cancel() {
      cancelled = true;
    }

    synchronized Status status() {
      return new Status(title, cancelled ? "ending …" : text, done, total, asked);
    }

    /** Which recordings will be read. */
    synchronized void reading(List<Path> recordings) {
      logs = List.copyOf(recordings);
    }

    /**
     * Ends a cancelled task.
     *
     * @throws CancellationException when it is
     */
    void check() {
      if (cancelled) {
        throw new CancellationException();
      }
    }

    /** Lets some time pass; ends when the task is cancelled. */
    void pause(long millis) {
      long end = System.nanoTime() + millis * 1_000_000;
      try {
        while (System.nanoTime() < end) {
          check();
          Thread.sleep(20);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new CancellationException();
      }
    }

    @Override
    public void read(Path log, long bytesRead, long totalBytes) {
      int index = Math.max(0, logs.indexOf(log));
      double part = totalBytes > 0 ? bytesRead / (double) totalBytes : 0;
      say("reading " + log.getFileName(), index + part, Math.max(1, logs.size()));
    }

    @Override
    public void fitting(int kicks) {
      say("fitting", 0, kicks);
    }

    @Override
    public void fitted() {
      synchronized (this) {
        // Kicks are fitted in several threads.
        done++;
      }
      say("fitting", -1, -1);
    }

    @Override
    public void diagnosing(String what) {
      say(what, 0, 0);
    }

    private void say(String words, double howMany, double ofHowMany) {
      check();
      boolean tell;
      synchronized (this) {
        tell = !text.equals(words);
        text = words;
        if (howMany >= 0) {
          done = howMany;
          total = ofHowMany;
        }
        long now = System.nanoTime() / 1_000_000;
        tell |= now - told > TELL_MS;
        told = tell ? now : told;
      }
      if (tell) {
        listener.changed();
      }
    }
  }
}
