#lang racket/base
;; Systems that are followed, told to whoever asks: to the command that exports those of a program.

(provide call-watching-systems call-unwatched note-followed)

(define watcher (make-parameter #f))

;; told : maker, list of parameters, state -> void; called where a motion is begun
(define (call-watching-systems told use) (parameterize ([watcher told]) (use)))

;; What is followed in there is no system of the reader's.
(define (call-unwatched use) (if (watcher) (parameterize ([watcher #f]) (use)) (use)))

;; maker : a state derivative, or what makes one of the parameters
(define (note-followed maker parameters state)
  (define told (watcher))
  (when told (told maker parameters state)))
