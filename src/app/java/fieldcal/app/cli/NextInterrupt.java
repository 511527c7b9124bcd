package fieldcal.app.cli;

import java.lang.reflect.Proxy;

/** A Ctrl-C while the program ends already, of which Java takes no notice by itself. */
final class NextInterrupt {
  private NextInterrupt() {}

  /**
   * Does something at the next Ctrl-C.
   *
   * @param action run on a thread of the machine's; should return quickly
   */
  static void then(Runnable action) {
    try {
      // By name, since it is no part of Java's public interface; all of its virtual machines have
      // it.
      Class<?> signal = Class.forName("sun.misc.Signal");
      Class<?> handler = Class.forName("sun.misc.SignalHandler");
      Object acting =
          Proxy.newProxyInstance(
              handler.getClassLoader(),
              new Class<?>[] {handler},
              (proxy, method, arguments) -> {
                action.run();
                return null;
              });
      Object interrupt = signal.getConstructor(String.class).newInstance("INT");
      signal.getMethod("handle", signal, handler).invoke(null, interrupt, acting);
    } catch (ReflectiveOperationException | IllegalArgumentException e) {
      // Then nobody can hurry it; it ends by itself within seconds.
      return;
    }
  }
}
