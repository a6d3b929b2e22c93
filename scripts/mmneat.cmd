@echo off
rem Runs MM-NEAT from a checkout on Windows: builds the jar when it is missing, then hands all words on.
rem   scripts\mmneat task=blended runs=2
rem After a change of the sources, build it again: mvnw -Dmaven.test.skip=true package
setlocal
set "home=%~dp0.."
set "jar=%home%\target\mmneat.jar"
if defined JAVA_HOME (set "java=%JAVA_HOME%\bin\java.exe") else (set "java=java")
"%java%" -version >nul 2>&1 || (echo mmneat: no Java found. Install a JDK 17 or newer, or set JAVA_HOME. 1>&2 & exit /b 2)
if not exist "%jar%" (
  echo mmneat: building target\mmneat.jar, longer on the first build on a machine 1>&2
  call "%home%\mvnw.cmd" -f "%home%\pom.xml" --batch-mode --quiet -Dmaven.test.skip=true package 1>&2 || exit /b 2
)
"%java%" %MMNEAT_JAVA_OPTIONS% "-Dmmneat.command=%~0" -jar "%jar%" %*
