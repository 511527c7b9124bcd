#!/bin/sh
# Hands its arguments to Gradle. Takes the machine's own Gradle, JDK 17 and, for tests, chromium, and installs them with apt-get where they
# are missing, instead of downloading a distribution. Builds need nothing else that is not declared in build.gradle.
set -eu

say() { echo "gradlew: $*" >&2; }

root=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd -P)

# A JDK has a compiler, and the file "release" tells its version.
is_jdk17() { [ -x "$1/bin/javac" ] && grep -q '^JAVA_VERSION="17\.' "$1/release" 2>/dev/null; }

find_jdk17() {
  if [ -n "${JAVA_HOME:-}" ] && is_jdk17 "$JAVA_HOME"; then
    echo "$JAVA_HOME"
    return
  fi
  javac=$(command -v javac 2>/dev/null) && javac=$(readlink -f "$javac" 2>/dev/null) || javac=''
  for home in "${javac%/bin/javac}" /usr/lib/jvm/*17* /usr/java/*17* /Library/Java/JavaVirtualMachines/*17*/Contents/Home; do
    if [ -n "$home" ] && is_jdk17 "$home"; then
      echo "$home"
      return
    fi
  done
}

install() {
  if ! command -v apt-get >/dev/null 2>&1; then
    say "needs $*, and there is no apt-get to install it with; please install it"
    exit 1
  fi
  as_root=''
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
      say "please run as root: apt-get install $*"
      exit 1
    fi
    as_root=sudo
  fi
  say "installing $* (apt-get, once)"
  log=$(mktemp)
  if ! { $as_root apt-get update && $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"; } >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    rm -f "$log"
    say "could not install $*; please install it"
    exit 1
  fi
  rm -f "$log"
}

missing=''
command -v gradle >/dev/null 2>&1 || missing='gradle'
jdk=$(find_jdk17)
[ -n "$jdk" ] || missing="$missing openjdk-17-jdk-headless"
if [ -n "$missing" ]; then
  # shellcheck disable=SC2086 # two package names, two words
  install $missing
  jdk=$(find_jdk17)
  [ -n "$jdk" ] || { say "found no JDK 17 after installing it"; exit 1; }
fi
JAVA_HOME=$jdk
export JAVA_HOME

# The console's tests need a browser. Where it cannot be installed they fail and say so; all else still runs.
has_browser() {
  { command -v chromium || command -v chromium-browser; } >/dev/null 2>&1 &&
    { command -v chromedriver || [ -x /usr/lib/chromium-browser/chromedriver ]; } >/dev/null 2>&1
}
case " $* " in
  *' test '* | *' check '* | *' build '* | *' unitTest '* | *' screenshots '*)
    if ! has_browser; then
      (install chromium chromium-driver) || say "the browser tests will fail: no chromium and chromedriver"
    fi
    ;;
esac

# Gradle keeps what it downloads in the home that the user database knows. Containers may run us as a user without one.
if [ -z "${GRADLE_USER_HOME:-}" ]; then
  home=$(getent passwd "$(id -u)" 2>/dev/null | cut -d: -f6) || home=${HOME:-}
  if [ -z "$home" ] || [ ! -w "$home" ]; then
    if [ -n "${HOME:-}" ] && [ -w "$HOME" ]; then
      GRADLE_USER_HOME=$HOME/.gradle
    else
      GRADLE_USER_HOME=$root/.gradle/user-home
    fi
    export GRADLE_USER_HOME
  fi
fi

# A build compiles each source once and ends: Java's thorough compiler would take a third of the processor time and save none.
GRADLE_OPTS="-XX:TieredStopAtLevel=1 ${GRADLE_OPTS-}"
export GRADLE_OPTS

exec gradle --no-daemon -p "$root" "$@"
