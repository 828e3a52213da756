#!/bin/sh
# czt_build.sh FOLDER [CLONE]: builds the parts of CZT that read, type-check and animate Z, in FOLDER, and prints the path
# of one jar, for CZT_JAR. It takes the commit of public_corpus.tsv from the public repository, or from CLONE. git, Maven 3,
# a JDK of 11 to 17 and unzip do it, with Maven Central, in two minutes. A jar that FOLDER has is printed at once.
# Exit status: 0 printed; 1 not built, with the last of the log; 77 a program or the repository is absent.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
mkdir -p "$1"
folder=$(CDPATH='' cd -- "$1" && pwd)
clone=${2:-}
jar=$folder/czt.jar
[ ! -s "$jar" ] || { echo "$jar"; exit 0; }
for program in git mvn javac unzip; do
  command -v "$program" >/dev/null || { echo "skipped: no $program to build CZT with" >&2; exit 77; }
done

commit=$(sed -n 's|^community-z-users/czt\t\([0-9a-f]*\)\t.*|\1|p' "$here/public_corpus.tsv")
if [ -z "$clone" ]; then
  clone=$folder/clone
  git init -q "$clone"
  git -C "$clone" fetch -q --depth 1 https://github.com/community-z-users/czt "$commit" || {
    echo "skipped: community-z-users/czt cannot be had at $commit" >&2
    exit 77
  }
fi
source=$folder/source
mkdir -p "$source"
git -C "$clone" archive -o "$folder/source.tar" "$commit" pom.xml dev zml session corejava parser typechecker \
  util rules zlive 2>"$folder/log"
tar -xf "$folder/source.tar" -C "$source"

# CZT's generator of classes uses the XPath of the JDK's own, which Java 9 and later keep to themselves.
sed -i '/<module>\(gaffe2\{0,1\}\|vcg\|z2b\|z2alloy\|zeves\|ui\|jedit\)</d' "$source/pom.xml"
MAVEN_OPTS="${MAVEN_OPTS:-} --add-exports=java.xml/com.sun.org.apache.xpath.internal=ALL-UNNAMED"
export MAVEN_OPTS
mvn -B -q -f "$source/pom.xml" -DskipTests -pl zlive -am package \
  org.apache.maven.plugins:maven-dependency-plugin:3.6.0:copy-dependencies -DincludeScope=runtime \
  -DoutputDirectory="$folder/jars" >"$folder/log" 2>&1 || { tail -20 "$folder/log" >&2; exit 1; }

# One jar has CZT, the runtime of its parsers, and JAXB, which Java 11 and later lack.
cp "$source"/zlive/target/zlive-*-SNAPSHOT.jar "$folder/jars"
for one in corejava parser session util typechecker rules zlive java-cup-runtime jakarta jaxb txw2 istack commons-cli; do
  for part in "$folder/jars/$one"*.jar; do unzip -qo "$part" -d "$folder/classes"; done
done
jar -c -f "$folder/czt.new" -C "$folder/classes" .
mv "$folder/czt.new" "$jar"
echo "$jar"
