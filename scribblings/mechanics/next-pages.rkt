#lang racket/base
;; The end of a page of the guide: pages to read next, each with what is there.
;;
;;     @next-pages["residuals" "what a verdict says" "constraints" "rods, tracks and wheels"]

(require scribble/base)

(provide next-pages)

(define (next-pages . tags-and-contents)
  (list (para (bold "Read next"))
        (apply itemlist
               (let loop ([left tags-and-contents])
                 (if (null? left)
                     '()
                     (cons (item (secref (car left)) ": " (cadr left) ".")
                           (loop (cddr left))))))))
