#lang racket/base
;; Systems that are followed, reported to a watcher: the command that exports those of a program.

(provide call-watching-systems call-unwatched note-followed)

(define watcher (make-parameter #f))

;; report : maker, list of parameters, state -> void; called where a motion is begun
(define (call-watching-systems report use) (parameterize ([watcher report]) (use)))

;; (use), in which systems of the library are followed, which are not reported.
(define (call-unwatched use) (parameterize ([watcher #f]) (use)))

;; maker : a state derivative, or a procedure that makes one of the parameters
(define (note-followed maker parameters state)
  (define report (watcher))
  (when report (report maker parameters state)))
