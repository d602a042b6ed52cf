# frontier_pilot in Debian 12, for those who have another system; docs/install.md says how it is used, with windows too.
#   docker build -t frontier_pilot .
FROM debian:12 AS build
ENV DEBIAN_FRONTEND=noninteractive
WORKDIR /build/source
RUN apt-get update && apt-get install -y --no-install-recommends dpkg-dev
# What is built is only looked at after what it needs is installed, so that a change of the sources does not install that again.
COPY debian/ debian/
RUN apt-get build-dep -y --no-install-recommends ./
COPY . .
RUN dpkg-buildpackage -b -us -uc

FROM debian:12
ENV DEBIAN_FRONTEND=noninteractive
COPY --from=build /build/*.deb /tmp/packages/
# The packages as anyone installs them, and what terminals and windows need besides: the tools of ROS, OpenGL without a
# graphics card, and Qt for Wayland.
RUN apt-get update \
 && apt-get install -y /tmp/packages/frontier-pilot_*.deb /tmp/packages/frontier-pilot-rviz_*.deb \
      libgl1-mesa-dri qtwayland5 python3-rosmsg python3-rosparam \
 && rm -rf /tmp/packages /var/lib/apt/lists/*
RUN useradd --create-home --uid 1000 pilot
COPY docker/entry_point docker/explore scripts/running_system.py scripts/command_line.py /usr/local/bin/
USER pilot
WORKDIR /home/pilot
RUN mkdir .ros  # so that a volume that is mounted here belongs to this user
ENV LC_ALL=C.UTF-8
ENTRYPOINT ["/usr/local/bin/entry_point"]
CMD ["explore"]
