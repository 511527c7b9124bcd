package fieldcal.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.module.ModuleFinder;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import org.apache.commons.math3.util.FastMath;
import org.junit.jupiter.api.Test;

/** The jar that hosts link stands beside any protobuf and any messages of theirs. {@code examples/host} is such a host. */
class LibraryJarTest {
  private static final Path JAR =
      Path.of(
          System.getProperty("fieldcal.projectDir", "."),
          "build/libs/fieldcal-" + System.getProperty("fieldcal.version") + ".jar");

  @Test
  void hasNothingOutsideItsOwnPackages() throws IOException {
    try (JarFile jar = new JarFile(JAR.toFile())) {
      List<String> names =
          jar.stream().filter(entry -> !entry.isDirectory()).map(e -> e.getName()).toList();
      assertThat(names)
          .allMatch(name -> name.startsWith("fieldcal/") || name.startsWith("META-INF/"));
      assertThat(names)
          .contains(
              "fieldcal/shaded/protobuf/CodedInputStream.class",
              "META-INF/LICENSE",
              "META-INF/NOTICE",
              "META-INF/licences/protobuf.txt");
      assertThat(names).noneMatch(name -> name.startsWith("fieldcal/app/"));
    }
  }

  @Test
  void isAModule() {
    assertThat(ModuleFinder.of(JAR).find("fieldcal")).isPresent();
  }

  /** Beside commons-math3 alone: no protobuf but its own can be found. */
  @Test
  void readsMessagesWithItsOwnProtobuf() throws Exception {
    URL math = FastMath.class.getProtectionDomain().getCodeSource().getLocation();
    try (URLClassLoader host =
        new URLClassLoader(
            new URL[] {JAR.toUri().toURL(), math}, ClassLoader.getPlatformClassLoader())) {
      Class<?> epoch = host.loadClass("fieldcal.vision.Epoch");
      Class<?> decoder = host.loadClass("fieldcal.vision.VisionDecoder");
      Object made =
          decoder
              .getConstructor(epoch)
              .newInstance(epoch.getConstructor(long.class).newInstance(0L));
      // SSL_WrapperPacket { detection { frame_number: 7 t_capture: 1 t_sent: 1 camera_id: 2 } }
      byte[] packet = {
        0x0a,
        0x16,
        0x08,
        0x07,
        0x11,
        0,
        0,
        0,
        0,
        0,
        0,
        (byte) 0xf0,
        0x3f,
        0x19,
        0,
        0,
        0,
        0,
        0,
        0,
        (byte) 0xf0,
        0x3f,
        0x20,
        0x02
      };
      Object read = decoder.getMethod("decode", byte[].class).invoke(made, packet);
      assertThat(read.toString()).contains("cameraId=2").contains("frameNumber=7");
    }
  }
}
