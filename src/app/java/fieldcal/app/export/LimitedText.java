package fieldcal.app.export;

import java.io.IOException;
import java.net.http.HttpResponse.BodySubscriber;
import java.net.http.HttpResponse.BodySubscribers;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Flow.Subscription;

/** The text of an answer, given up when it is longer than any that is meant. */
final class LimitedText implements BodySubscriber<String> {
  /** A configuration has some ten thousand bytes. */
  static final int LONGEST = 4 << 20;

  private final BodySubscriber<String> text = BodySubscribers.ofString(StandardCharsets.UTF_8);
  private Subscription subscription;
  private long bytes;

  @Override
  public void onSubscribe(Subscription to) {
    subscription = to;
    text.onSubscribe(to);
  }

  @Override
  public void onNext(List<ByteBuffer> next) {
    for (ByteBuffer one : next) {
      bytes += one.remaining();
    }
    if (bytes > LONGEST) {
      subscription.cancel();
      text.onError(new IOException("its answer is longer than " + LONGEST + " bytes"));
    } else {
      text.onNext(next);
    }
  }

  @Override
  public void onError(Throwable why) {
    text.onError(why);
  }

  @Override
  public void onComplete() {
    text.onComplete();
  }

  @Override
  public CompletionStage<String> getBody() {
    return text.getBody();
  }
}
