# Build: the toolchain stays behind in this stage.
FROM rust:1.95-bookworm AS build
WORKDIR /build
COPY . .
RUN cargo build --release --locked --bin terramechanics

# Run: C library and certificates, no shell, no package manager.
FROM gcr.io/distroless/cc-debian12:nonroot
LABEL org.opencontainers.image.title="terramechanics" \
      org.opencontainers.image.description="Forces of a wheel on soil, over HTTP: an API and a plotting page" \
      org.opencontainers.image.licenses="MIT"
COPY --from=build /build/target/release/terramechanics /usr/local/bin/terramechanics
# The image's nonroot, by number: Kubernetes cannot tell from a name that it is not root.
USER 65532:65532
# In a container the page has to be reached from outside it.
ENV TERRAMECHANICS_LISTEN=0.0.0.0:8080
EXPOSE 8080
# The program asks itself, as there is no shell and no curl to do it.
HEALTHCHECK --interval=10s --timeout=5s --start-period=5s --retries=3 CMD ["/usr/local/bin/terramechanics", "healthcheck"]
ENTRYPOINT ["/usr/local/bin/terramechanics"]
