@echo off
rem Runs fieldcal with the libraries beside it; needs a Java 17 or newer.
setlocal
set "LIB=%~dp0..\lib"
set "JAVA=java"
if defined JAVA_HOME if exist "%JAVA_HOME%\bin\java.exe" set "JAVA=%JAVA_HOME%\bin\java.exe"
if "%JAVA%"=="java" (
  where java >nul 2>nul
  if errorlevel 1 (
    echo fieldcal: found no java; set JAVA_HOME to a Java 17 or newer 1>&2
    exit /b 1
  )
)

rem The same options as in the file fieldcal, which says why.
set "TUNING=-XX:+UseParallelGC"
set "HOTONLY=-XX:Tier4InvocationThreshold=100000 -XX:Tier4MinInvocationThreshold=12000 -XX:Tier4CompileThreshold=300000 -XX:Tier4BackEdgeThreshold=800000"
if "%~1"=="console" set "TUNING=-XX:+UseParallelGC -Xmx512m"
if "%~1"=="diagnose" set "TUNING=%HOTONLY% -XX:+UseSerialGC -Xms96m -Xmx1g -XX:MinHeapFreeRatio=20 -XX:MaxHeapFreeRatio=40"
if "%~1"=="twin" set "TUNING=%HOTONLY% -XX:+UseSerialGC -Xms96m -XX:MinHeapFreeRatio=20 -XX:MaxHeapFreeRatio=40"
if "%~1"=="compare" set "TUNING=%HOTONLY% -XX:+UseSerialGC -Xms96m -XX:MinHeapFreeRatio=20 -XX:MaxHeapFreeRatio=40"

set "QUICK=-XX:TieredStopAtLevel=1 -XX:+UseSerialGC"
set "FIRST=%~1"
if not defined FIRST set "TUNING=%QUICK%"
if "%FIRST:~0,1%"=="-" set "TUNING=%QUICK%"
if "%~1"=="info" goto short
if "%~1"=="calibrate" goto short
if "%~1"=="monitor" goto short
goto run

:short
set "TUNING=%QUICK%"
:next
shift /1
if "%~1"=="" goto run
set "SIZE=%~z1"
if not defined SIZE set "SIZE=0"
if %SIZE% GTR 104857600 set "TUNING=-XX:+UseParallelGC"
goto next

:run
"%JAVA%" %TUNING% -Xshare:auto -Dfile.encoding=UTF-8 -Dsun.stdout.encoding=UTF-8 -Dsun.stderr.encoding=UTF-8 ^
  -Djava.awt.headless=true %FIELDCAL_JAVA_OPTS% -cp "%LIB%\*" fieldcal.app.cli.Main %*
exit /b %ERRORLEVEL%
